"""What the report on the desk's trimmer tells, and how machines are drawn, kept to be read in a diff.

``python -m tests.report.design.told`` writes both anew.
"""

import tempfile
from pathlib import Path

from report.cache.stage_store import StageStore
from report.design.building import report_on
from report.design.diagram.diagram import mechanism_diagram
from report.design.markdown import to_markdown
from report.design.report import DesignReport
from report.pages.drawing.style import style
from tests.report.design.conftest import look
from tests.report.figures import told as figures
from tests.report.markdown_lines import markdown_lines
from trimmer import Mechanism

TOLD = Path(__file__).with_name("told.txt")
DRAWN = Path(__file__).with_name("diagrams.txt")
EXAMPLES = Path(__file__).parents[3] / "examples"
MACHINES = "bouncing-ball", "two-mass-servo", "lever-valve"  # In which each symbol is drawn


def told(report: DesignReport) -> str:
    """Return its Markdown with a line for each row of a table, without what it was made from."""
    return markdown_lines(to_markdown(report), without="provenance")


def diagrams() -> str:
    """Return what is drawn of machines, line by line."""
    with style():
        drawn = {name: mechanism_diagram(Mechanism.from_toml(EXAMPLES / f"{name}.toml")) for name in MACHINES}
        return "".join("\n".join([f"== {name}", *figures.told(each), ""]) for name, each in drawn.items())


def _renew() -> None:
    DRAWN.write_text(diagrams(), "utf-8")
    with tempfile.TemporaryDirectory() as folder:
        store = StageStore(Path(folder))
        TOLD.write_text(told(report_on(look(store), store, "2026-03-01")), "utf-8")


if __name__ == "__main__":
    _renew()
