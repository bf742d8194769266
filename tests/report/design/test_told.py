"""The report on a design tells what it told: ``told.py`` says what is kept of it and renews it."""

import pytest

from report.design.report import DesignReport
from tests.report.design.told import (
    COMPARED,
    DRAWN,
    TOLD,
    WITHOUT_DRIVE,
    diagrams,
    kept_without_drive,
    side_by_side,
    told,
    without_drive,
)
from tests.trimmer.command_line.alike import alike


def assert_alike(kept: list[str], found: list[str]) -> None:
    assert [pair for pair in zip(kept, found, strict=False) if not alike(*pair)] == []
    assert len(found) == len(kept)


def test_the_report_tells_what_it_told(report: DesignReport) -> None:
    assert_alike(TOLD.read_text("utf-8").splitlines(), told(report).splitlines())


def test_machines_are_drawn_as_they_were() -> None:
    assert_alike(DRAWN.read_text("utf-8").splitlines(), diagrams().splitlines())


@pytest.mark.parametrize("name", WITHOUT_DRIVE)
def test_what_moves_without_a_drive_is_told_as_it_was(name: str) -> None:
    assert_alike(kept_without_drive()[name].splitlines(), without_drive(name).splitlines())


def test_two_machines_are_compared_as_they_were() -> None:
    assert_alike(kept_without_drive()[" and ".join(COMPARED)].splitlines(), side_by_side().splitlines())
