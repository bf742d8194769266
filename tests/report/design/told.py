"""What the report on the desk's trimmer tells, kept in a file that is read in a diff when it changes.

``python -m tests.report.design.told`` writes it anew.
"""

import tempfile
from pathlib import Path

from report.cache.stage_store import StageStore
from report.design.building import report_on
from report.design.markdown import to_markdown
from report.design.report import DesignReport
from tests.report.design.conftest import look
from tests.report.markdown_lines import markdown_lines

TOLD = Path(__file__).with_name("told.txt")


def told(report: DesignReport) -> str:
    """Return its Markdown with a line for each row of a table, without what it was made from."""
    return markdown_lines(to_markdown(report), without="provenance")


def _renew() -> None:
    with tempfile.TemporaryDirectory() as folder:
        store = StageStore(Path(folder))
        TOLD.write_text(told(report_on(look(store), store, "2026-03-01")), "utf-8")


if __name__ == "__main__":
    _renew()
