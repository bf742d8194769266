"""What speaks against a drive that was given, on lines made by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.fitting.known import measured
from trimmer.fitting import doubted_drive
from trimmer.fitting.doubted_drive import doubts_of
from trimmer.fitting.measured import MeasuredLines
from trimmer.fitting.stray import StrayLine
from trimmer.signals.signal import Signal, SignalError

LINES = np.array([[-30.0 + 0j, 1.0], [40.0j, 900.0]])
"""Of two outputs, at 50 and 100 Hz, in a noise of 1; the record lasts 2 s."""


def given(lines: np.ndarray = LINES, *strays: StrayLine, **others: Any) -> MeasuredLines:
    return replace(measured(lines, strays=strays, **others), found=False)


@pytest.fixture(autouse=True)
def own(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The drive that is found in a record: the last of the list; without any it is the one that was given."""
    found: list[Any] = []

    def drive_near(signal: Signal, near: float, periods: int) -> float:
        assert (signal.name, near, periods) == ("s0", 50.0, 1)
        if not found:
            return near
        if isinstance(found[-1], Exception):
            raise found[-1]
        return float(found[-1])

    monkeypatch.setattr(doubted_drive, "drive_near", drive_near)
    return found


def stray(frequency: float, amplitude: float, output: str = "s0") -> StrayLine:
    return StrayLine(output, frequency, amplitude, 1e3, None)


def test_the_largest_line_of_the_first_output_may_be_no_multiple_of_the_drive() -> None:
    assert list(doubts_of(given(LINES, stray(60.0, 39.0), stray(70.0, 40.0), stray(80.0, 5.0)))) == []
    (told,) = doubts_of(given(LINES, stray(60.0, 39.0), stray(73.123456, 41.0), stray(80.0, 5.0)))
    assert told.startswith(
        "the largest line of the record is at 73.123 Hz, no multiple of the drive: is --drive 50"
    )
    assert list(doubts_of(given(LINES, stray(60.0, 800.0, "s1")))) == []
    assert list(doubts_of(replace(given(LINES, stray(60.0, 41.0)), found=True))) == []


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("period_count", [1, 2])
def test_the_own_lines_of_a_record_may_lie_elsewhere(own: list[Any], sign: float, period_count: int) -> None:
    lines = np.vstack([LINES] * period_count)
    # By the end of 2 s the second harmonic is a quarter of a period off.
    own.append(50.0 + sign * 0.0626)
    (told,) = doubts_of(given(lines, period_count=period_count))
    assert told.startswith(
        f"the record's own lines are at multiples of {own[0]:.8g} Hz: is --drive 50 right?"
    )
    own.append(50.0 + sign * 0.0624)
    assert list(doubts_of(given(lines, period_count=period_count))) == []


def test_of_several_doubts_the_first_is_told(own: list[Any]) -> None:
    own.append(51.0)
    (told,) = doubts_of(given(LINES, stray(60.0, 41.0)))
    assert "largest line" in told
    own.append(SignalError("there is no drive"))
    assert list(doubts_of(given())) == []


@pytest.mark.parametrize(
    ("seen", "period_count", "drive"),
    [
        ((1, 2, 3), 1, None),
        ((2, 4), 1, 100.0),
        ((2, 3), 1, None),
        ((3, 6), 1, 150.0),
        ((2, 4), 2, None),
        ((3, 6), 2, 75.0),
        ((4,), 2, 100.0),
        ((), 1, None),
    ],
)
def test_all_lines_may_be_at_multiples_of_a_higher_drive(
    seen: tuple[int, ...], period_count: int, drive: float | None
) -> None:
    lines = np.full((6, 2), 10.0 + 0j)
    for order in seen:
        lines[order - 1, order % 2] = -10.1j
    told = list(doubts_of(given(lines, period_count=period_count)))
    assert len(told) == (drive is not None)
    if drive is not None:
        assert told[0].startswith(
            f"all lines of the record are at multiples of {drive:g} Hz: is --drive 50 right?"
        )
