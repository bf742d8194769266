"""The report on a design tells what it told: ``told.py`` says what is kept of it and renews it."""

from report.design.report import DesignReport
from tests.report.design.told import TOLD, told
from tests.trimmer.command_line.alike import alike


def test_the_report_tells_what_it_told(report: DesignReport) -> None:
    kept, found = TOLD.read_text("utf-8").splitlines(), told(report).splitlines()
    assert [pair for pair in zip(kept, found, strict=False) if not alike(*pair)] == []
    assert len(found) == len(kept)
