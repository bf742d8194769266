"""What the report on the desk's trimmer tells, kept in a file that is read in a diff when it changes.

``python -m tests.report.design.told`` writes it anew.
"""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from report.cache.stage_store import StageStore
from report.design.building import report_on
from report.design.markdown import to_markdown
from report.design.report import DesignReport
from tests.report.design.conftest import look

TOLD = Path(__file__).with_name("told.txt")


def told(report: DesignReport) -> str:
    """Return its Markdown with a line for each row of a table, without what it was made from."""
    pages = to_markdown(report)
    text = "\n".join(f"# {name}\n{page}" for name, page in pages.items() if name != "provenance")
    text = re.sub(r"\n::::?(?: (?:row|cell))?(?=\n)", " |", re.sub(r"\\(?=[^\w\s])", "", text))
    return re.sub(r"(?:[ |]*\n)+", "\n", re.sub(r"(?:[ |]*\|)\n(?=\S)", " | ", text)).strip() + "\n"


def _renew() -> None:
    with tempfile.TemporaryDirectory() as folder:
        store = StageStore(Path(folder))
        TOLD.write_text(told(report_on(look(store), store, "2026-03-01")), "utf-8")


if __name__ == "__main__":
    _renew()
