from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer.errors import WrongTypeError
from trimmer.signals.signal import SignalError
from trimmer.spectra.classification import (
    ClassifiedPeak,
    Harmonic,
    LimitCycleLine,
    NaturalMode,
    Tolerance,
    classify,
)
from trimmer.spectra.peaks import Peak

MODES = (222.35, 354.84, 549.59, 1139.5)


def only(frequency: float, bin_width: float = 1.0, **options) -> ClassifiedPeak:
    (classified,) = classify([Peak(frequency, 1.0, 0.0)], bin_width, **options)
    return classified


def test_a_harmonic_of_the_drive_has_its_order_and_parity() -> None:
    for order in range(1, 30):
        match = only(order * 109.845 + 0.2, drive_frequency=109.845).explanation
        assert match is not None
        assert isinstance(match.origin, Harmonic)
        assert (match.origin.order, match.origin.odd) == (order, order % 2 == 1)
        assert match.distance == pytest.approx(0.2)


def test_words_for_what_a_peak_may_be() -> None:
    assert Harmonic(1, 110.0).label == "drive"
    assert Harmonic(3, 330.0).label == "harmonic 3 (odd)"
    assert Harmonic(4, 440.0).label == "harmonic 4 (even)"
    assert NaturalMode(2, 355.0).label == "natural mode 2"
    assert LimitCycleLine(1, 1, 734.0).label == "limit cycle 1"
    assert LimitCycleLine(1, 3, 2202.0).label == "limit cycle 1, harmonic 3"


def test_a_natural_mode_and_a_limit_cycle_are_found() -> None:
    mode, cycle = only(355.0, natural_frequencies=MODES), only(734.0, limit_cycle_frequencies=[554.3, 733.6])
    assert mode.explanation is not None
    assert mode.explanation.origin == NaturalMode(2, 354.84)
    assert cycle.explanation is not None
    assert cycle.explanation.origin == LimitCycleLine(2, 1, 733.6)
    third = only(2199.0, limit_cycle_frequencies=[733.6]).explanation
    assert third is not None
    assert third.origin == LimitCycleLine(1, 3, pytest.approx(2200.8))
    assert only(1467.2, limit_cycle_frequencies=[733.6]).explanation is None  # even: no candidate


def test_the_fifth_harmonic_of_110_hz_falls_on_the_third_mode() -> None:
    """The thesis reads 549.999 Hz as the fifth harmonic; the linear model has a mode at 549.59 Hz as well."""
    classified = only(549.999, drive_frequency=110.0, natural_frequencies=MODES)
    assert classified.ambiguous
    assert classified.explanation is not None
    assert classified.second is not None
    assert classified.explanation.origin == Harmonic(5, 550.0)
    assert classified.second.origin == NaturalMode(3, 549.59)
    assert classified.second.distance == pytest.approx(0.409, abs=1e-3)


def test_366_hz_is_neither_a_harmonic_of_110_hz_nor_near_a_mode() -> None:
    """The peak that the thesis reads as a limit cycle (section 3.3), at a bin width of 1 Hz."""
    classified = only(365.999, drive_frequency=110.0, natural_frequencies=MODES)
    assert classified.explanation is None
    assert classified.second is None
    assert not classified.ambiguous
    nearest = {type(match.origin): match.distance for match in classified.candidates}
    assert nearest == {Harmonic: pytest.approx(35.999), NaturalMode: pytest.approx(11.159)}


def test_a_mode_may_be_off_by_a_share_of_its_frequency_and_a_harmonic_may_not() -> None:
    assert only(354.84 * 1.0099, natural_frequencies=MODES).explanation is not None
    assert only(354.84 * 1.0101, natural_frequencies=MODES).explanation is None
    assert only(354.84 * 1.01, natural_frequencies=MODES, tolerance=Tolerance(model=0.0)).explanation is None
    assert only(111.01, drive_frequency=110.0).explanation is None
    assert only(111.01, bin_width=1.02, drive_frequency=110.0).explanation is not None
    assert only(111.01, drive_frequency=110.0, tolerance=Tolerance(bins=2.0)).explanation is not None


def test_overdamped_modes_are_left_out_and_the_others_keep_their_numbers() -> None:
    assert only(0.5, natural_frequencies=(0.0, 0.0)).candidates == ()
    (match,) = only(222.0, natural_frequencies=(0.0, 222.35)).candidates
    assert match.origin == NaturalMode(2, 222.35)


@given(
    frequency=st.floats(1.0, 5000.0),
    drive=st.none() | st.floats(10.0, 500.0),
    modes=st.lists(st.floats(0.0, 3000.0), max_size=5),
    cycles=st.lists(st.floats(1.0, 3000.0), max_size=3),
    bin_width=st.floats(1e-3, 20.0),
    closed=st.booleans(),
)
def test_candidates_are_the_nearest_of_each_kind_and_the_best_comes_first(
    frequency: float, drive, modes, cycles, bin_width: float, closed: bool
) -> None:
    classified = only(
        frequency,
        bin_width,
        drive_frequency=drive,
        natural_frequencies=modes,
        limit_cycle_frequencies=cycles,
        closed_loop=closed,
    )
    kinds = [type(match.origin) for match in classified.candidates]
    expected = {
        Harmonic: drive is not None,
        NaturalMode: any(modes),
        LimitCycleLine: bool(cycles) and (drive is None or closed),
    }
    assert sorted(kinds, key=str) == sorted([kind for kind, there in expected.items() if there], key=str)
    shares = [abs(match.distance) / match.tolerance for match in classified.candidates]
    assert shares == sorted(shares)
    assert [match.fits for match in classified.candidates] == [share <= 1 for share in shares]
    for match in classified.candidates:
        assert match.distance == pytest.approx((frequency - match.origin.frequency) / bin_width)
        if isinstance(match.origin, NaturalMode):
            away = min(abs(mode - frequency) for mode in modes if mode > 0)
            assert abs(match.distance) * bin_width == pytest.approx(away, abs=1e-9)
            assert match.origin.frequency == modes[match.origin.number - 1]
        if isinstance(match.origin, Harmonic):
            assert abs(match.distance) * bin_width <= 0.5 * drive + 1e-9 or match.origin.order == 1


@pytest.mark.parametrize(
    ("bin_width", "options", "message"),
    [
        (0.0, {}, "the bin width must be positive and finite, not 0.0"),
        (math.inf, {}, "the bin width"),
        (1.0, {"drive_frequency": -1.0}, "the frequency of the drive must be positive and finite, not -1.0"),
        (
            1.0,
            {"limit_cycle_frequencies": [733.0, 0.0]},
            "the frequency of a limit cycle must be .*, not 0.0",
        ),
        (
            1.0,
            {"natural_frequencies": [222.0, math.nan]},
            r"natural_frequencies\[1\] must be finite.*not nan",
        ),
        (1.0, {"natural_frequencies": [math.inf]}, r"natural_frequencies\[0\] must be finite"),
        (1.0, {"limit_cycle_frequencies": [math.nan]}, r"limit_cycle_frequencies\[0\] must be finite"),
    ],
)
def test_frequencies_and_tolerances_out_of_range_are_refused(bin_width, options, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        only(100.0, bin_width, **options)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"bins": 0.0}, "the tolerance in bins must be"),
        ({"bins": math.nan}, "the tolerance in bins must be"),
        ({"model": 1.0}, "the model tolerance must be 0 <= tolerance < 1, not 1.0"),
        ({"model": math.nan}, "the model tolerance must be"),
    ],
)
def test_tolerances_out_of_range_are_refused(values, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        Tolerance(**values)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"natural_frequencies": 222.0}, "natural_frequencies must be a sequence of frequencies"),
        ({"natural_frequencies": "222"}, "natural_frequencies must be a sequence of frequencies"),
        ({"natural_frequencies": [None]}, r"natural_frequencies\[0\] must be a real number"),
        ({"limit_cycle_frequencies": 733.6}, "limit_cycle_frequencies must be a sequence"),
        ({"drive_frequency": "110"}, "the frequency of the drive must be a real number, not '110'"),
        ({"tolerance": 1.0}, "tolerance must be a trimmer.Tolerance, not 1.0"),
    ],
)
def test_arguments_of_another_type_are_named(options, message: str) -> None:
    with pytest.raises(WrongTypeError, match=message):
        only(100.0, **options)


def test_a_driven_open_loop_has_no_limit_cycle() -> None:
    """Under a drive nothing feeds the output back to the pin."""
    on_the_spot = {"drive_frequency": 110.0, "limit_cycle_frequencies": [733.6]}
    assert only(733.6, **on_the_spot).explanation is None
    assert {type(match.origin) for match in only(733.6, **on_the_spot).candidates} == {Harmonic}
    closed = only(733.6, **on_the_spot, closed_loop=True).explanation
    assert closed is not None
    assert closed.origin == LimitCycleLine(1, 1, 733.6)
    assert only(733.6, limit_cycle_frequencies=[733.6]).explanation is not None


def test_what_are_no_peaks_is_named() -> None:
    with pytest.raises(WrongTypeError, match=r"peaks\[0\]"):
        classify([3.0], 1.0)
