"""What the report on the desk's trimmer tells, and how machines are drawn, kept to be read in a diff.

``python -m tests.report.design.told`` writes both anew.
"""

import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

from report.cache.stage_store import StageStore
from report.design.building import report_on
from report.design.comparison import ComparisonReport
from report.design.diagram.diagram import mechanism_diagram
from report.design.markdown import comparison_to_markdown, to_markdown
from report.design.origin import origin_of
from report.design.report import DesignReport
from report.pages.drawing.style import style
from tests.report.design.conftest import look
from tests.report.figures import told as figures
from tests.report.markdown_lines import markdown_lines
from tests.trimmer.servos import SAMPLED, STICTION
from trimmer import Mechanism, SerialRunner
from trimmer.design import Design, DesignSettings, Study, compared
from trimmer.design.specification.design_file import design_file_of_text

TOLD = Path(__file__).with_name("told.txt")
DRAWN = Path(__file__).with_name("diagrams.txt")
EXAMPLES = Path(__file__).parents[3] / "examples"
MACHINES = "bouncing-ball", "two-mass-servo", "lever-valve"  # In which each symbol is drawn


def told(report: DesignReport) -> str:
    """Return its Markdown with a line for each row of a table, without what it was made from."""
    return markdown_lines(to_markdown(report), without="provenance")


WITHOUT_DRIVE: Mapping[str, str] = MappingProxyType(
    {
        "hunts": STICTION + "[targets]\nhunting_at_most = 0\nrise_time_at_most = '20 ms'\n",
        "rests": SAMPLED,
        "switches": (EXAMPLES / "contactor.toml").read_text("utf-8"),
    }
)
"""Files of machines of which the short report is kept."""
SHORT = Path(__file__).with_name("without_drive.txt")


COMPARED = "hunts", "rests"


@cache
def _short(name: str) -> Design:
    file = design_file_of_text(WITHOUT_DRIVE[name], f"{name}.toml")
    return Study(file, DesignSettings(cells=2), SerialRunner()).short()


def without_drive(name: str) -> str:
    """Return what the short report tells of a machine without a drive, all but its equations."""
    design = _short(name)
    report = DesignReport(name, {}, origin_of([design.file], "2026-01-01"), design, None)
    return told(report).partition("# equations")[0]


def side_by_side() -> str:
    """Return what the report on two of them side by side tells."""
    before, after = map(_short, COMPARED)
    origin = origin_of([before.file, after.file], "2026-01-01")
    report = ComparisonReport("Both", {}, origin, compared(before, after), COMPARED)
    return markdown_lines(comparison_to_markdown(report)).partition("## What this rests on")[0]


def kept_without_drive() -> dict[str, str]:
    """Return what is kept of them."""
    pieces = (each.partition("\n") for each in SHORT.read_text("utf-8").split("== ")[1:])
    return {name: text for name, _, text in pieces}


def diagrams() -> str:
    """Return what is drawn of machines, line by line."""
    with style():
        drawn = {name: mechanism_diagram(Mechanism.from_toml(EXAMPLES / f"{name}.toml")) for name in MACHINES}
        return "".join("\n".join([f"== {name}", *figures.told(each), ""]) for name, each in drawn.items())


def _renew() -> None:
    DRAWN.write_text(diagrams(), "utf-8")
    short = {name: without_drive(name) for name in WITHOUT_DRIVE} | {" and ".join(COMPARED): side_by_side()}
    SHORT.write_text("".join(f"== {name}\n{each}" for name, each in short.items()), "utf-8")
    with tempfile.TemporaryDirectory() as folder:
        store = StageStore(Path(folder))
        TOLD.write_text(told(report_on(look(store), store, "2026-03-01")), "utf-8")


if __name__ == "__main__":
    _renew()
