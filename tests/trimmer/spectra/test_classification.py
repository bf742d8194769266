import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer.signals import SignalError
from trimmer.spectra import (
    ClassifiedPeak,
    DriveFraction,
    Harmonic,
    LimitCycleLine,
    NaturalMode,
    Peak,
    Tolerance,
    classify,
)

MODES = (222.35, 354.84, 549.59, 1139.5)


def only(frequency: float, bin_width: float = 1.0, **options) -> ClassifiedPeak:
    (classified,) = classify([Peak(frequency, 1.0, 0.0)], bin_width, **options)
    return classified


def test_words_for_what_a_peak_may_be() -> None:
    assert Harmonic(1, 110.0).label == "drive"
    assert Harmonic(3, 330.0).label == "harmonic 3 (odd)"
    assert Harmonic(4, 440.0).label == "harmonic 4 (even)"
    assert NaturalMode(2, 355.0).label == "natural mode 2"
    assert LimitCycleLine(1, 1, 734.0).label == "limit cycle 1"
    assert LimitCycleLine(1, 3, 2202.0).label == "limit cycle 1, harmonic 3"


def test_a_natural_mode_and_a_limit_cycle_are_found() -> None:
    mode, cycle = only(355.0, natural_frequencies=MODES), only(734.0, limit_cycle_frequencies=[554.3, 733.6])
    assert mode.explanation.origin == NaturalMode(2, 354.84)
    assert cycle.explanation.origin == LimitCycleLine(2, 1, 733.6)
    third = only(2199.0, limit_cycle_frequencies=[733.6]).explanation
    assert third.origin == LimitCycleLine(1, 3, pytest.approx(2200.8))
    assert only(1467.2, limit_cycle_frequencies=[733.6]).explanation is None  # even: no candidate


def test_a_line_between_the_harmonics_is_a_reduced_fraction_of_the_drive() -> None:
    third = only(2 * 110.0 / 6 + 0.09, drive_frequency=110.0).explanation
    assert third.origin == DriveFraction(1, 3, pytest.approx(110.0 / 3))
    assert third.origin.label == "1/3 of the drive"
    beside = only(165.0, drive_frequency=110.0)
    assert [type(match.origin) for match in beside.candidates] == [DriveFraction, Harmonic]
    assert only(165.11, drive_frequency=110.0).explanation is None  # By more than a tenth of a bin.
    assert only(330.0, drive_frequency=110.0).candidates[0].origin == Harmonic(3, 330.0)


def test_the_fifth_harmonic_of_110_hz_falls_on_the_third_mode() -> None:
    """The thesis reads 549.999 Hz as the fifth harmonic; the linear model has a mode at 549.59 Hz as well."""
    classified = only(549.999, drive_frequency=110.0, natural_frequencies=MODES)
    assert classified.ambiguous
    assert classified.explanation.origin == Harmonic(5, 550.0)
    assert classified.second.origin == NaturalMode(3, 549.59)
    assert classified.second.distance == pytest.approx(0.409, abs=1e-3)


def test_a_mode_may_be_off_by_a_share_of_its_frequency_and_a_harmonic_may_not() -> None:
    assert only(354.84 * 1.0099, natural_frequencies=MODES).explanation is not None
    assert only(354.84 * 1.0101, natural_frequencies=MODES).explanation is None
    assert only(354.84 * 1.01, natural_frequencies=MODES, tolerance=Tolerance(model=0.0)).explanation is None
    assert only(111.01, drive_frequency=110.0).explanation is None
    assert only(111.01, bin_width=1.02, drive_frequency=110.0).explanation is not None
    assert only(112.0, drive_frequency=110.0, tolerance=Tolerance(bins=2.0)).explanation is not None


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
    harmonic = any(each.fits for each in classified.candidates if isinstance(each.origin, Harmonic))
    near = [(round(frequency / drive * q), q) for q in range(2, 7)] if drive and not harmonic else []
    expected = {
        Harmonic: drive is not None,
        NaturalMode: any(modes),
        LimitCycleLine: bool(cycles) and (drive is None or closed),
        DriveFraction: any(p % q and abs(frequency - p * drive / q) <= 0.1 * bin_width for p, q in near),
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
        (1.0, {"limit_cycle_frequencies": [733.0, 0.0]}, "the frequency of a limit cycle must .*, not 0.0"),
        (1.0, {"natural_frequencies": [222.0, math.nan]}, r"natural_frequencies\[1\] must be finite"),
        (1.0, {"natural_frequencies": [math.inf]}, r"natural_frequencies\[0\] must be finite"),
        (1.0, {"limit_cycle_frequencies": [math.nan]}, r"limit_cycle_frequencies\[0\] must be finite"),
    ],
)
def test_frequencies_and_tolerances_out_of_range_are_refused(bin_width, options, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        only(100.0, bin_width, **options)
    in_bins, of_model = "tolerance in bins must be", "model tolerance must be 0 <= tolerance < 1, not"
    for bins, model, told in ((0.0, 0.0, in_bins), (math.nan, 0.0, in_bins), (1.0, 1.0, f"{of_model} 1.0"),
                              (1.0, math.nan, of_model)):  # fmt: skip
        with pytest.raises(SignalError, match=told):
            Tolerance(bins, model)
