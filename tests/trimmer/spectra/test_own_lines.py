"""What repeats without a drive is told by its multiples, and hum by those of the mains."""

import numpy as np
import pytest

from trimmer import Signal, analyse_signal
from trimmer.spectra import MainsHum, OwnMultiple, Peak, with_own_lines
from trimmer.spectra.own_lines import repetition

RATE = 2000.0


def recorded(lines: dict[float, float], seconds: float = 20.0) -> Signal:
    times = np.arange(int(seconds * RATE)) / RATE
    phases = np.linspace(0.3, 2.9, len(lines))
    sines = zip(lines.items(), phases, strict=True)
    return Signal(sum(a * np.sin(2 * np.pi * f * times + p) for (f, a), p in sines), RATE)


@pytest.mark.parametrize("base", [1.1193332784, 7.3, 41.0])
def test_a_limit_cycle_is_told_by_its_multiples_and_hum_by_that_of_the_mains(base: float) -> None:
    lines = {base: 1.0, 2 * base: 0.3, 3 * base: 0.4, 5 * base: 0.1, 100.02: 0.05, 180.0: 0.02, 333.3: 0.01}
    found = with_own_lines(analyse_signal(recorded(lines)))
    origins = [each.explanation and each.explanation.origin for each in found.peaks]
    labels = [None if each is None else (type(each), each.order) for each in origins]
    own = [(OwnMultiple, 1), (OwnMultiple, 3), (OwnMultiple, 2), (OwnMultiple, 5)]
    assert labels == [*own, (MainsHum, 2), (MainsHum, 3), None]
    hum = [f"hum of the mains, {n} x {f} Hz" for n, f in ((2, 50), (3, 60))]
    assert [each.label for each in origins[4:6]] == hum
    assert origins[1].frequency == pytest.approx(3 * base, rel=1e-5)


def test_a_known_period_is_taken_and_a_drive_has_none() -> None:
    signal = recorded({12.0: 1.0, 36.0: 0.2, 50.0: 0.1})
    given = with_own_lines(analyse_signal(signal), 4.0, (60.0,)).peaks
    assert [each.explanation and each.explanation.origin for each in given] == [
        OwnMultiple(3, 12.0),
        OwnMultiple(9, 36.0),
        None,
    ]
    driven = with_own_lines(analyse_signal(signal, 12.0)).peaks
    assert not any(isinstance(match.origin, OwnMultiple) for each in driven for match in each.candidates)


@pytest.mark.parametrize(
    "lines",
    [
        {10.0: 1.0, 20.0: 0.5},  # Two alone may be chance.
        {10.0: 0.1, 20.0: 0.1, 30.0: 0.1, 47.7: 1.0},  # Most of the power is another line's.
        {10.0: 1.0, 20.37: 0.5, 30.61: 0.4},
        {},
    ],
)
def test_nothing_repeats_where_few_lines_or_little_power_are_multiples(lines: dict[float, float]) -> None:
    assert repetition([Peak(each, size, 0.0) for each, size in lines.items()], 0.5) is None
