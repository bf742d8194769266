"""Lines of records whose noise is known."""

import numpy as np
import pytest

from trimmer.fitting.doubted_drive import doubts_of
from trimmer.fitting.measured import MeasuredLines, measure_lines
from trimmer.signals import Signal, SignalError

RATE, COUNT, DRIVE = 2000.0, 2000, 50.0
TIMES = np.arange(COUNT) / RATE


def lines(
    noise: np.ndarray, *more: np.ndarray, drive: float | None = DRIVE, rate: float = RATE
) -> MeasuredLines:
    tone = np.cos(2 * np.pi * DRIVE * TIMES) + 0.1 * np.cos(2 * np.pi * 3 * DRIVE * TIMES)
    signals = {f"s{i}": Signal(tone + each, rate, f"s{i}", "m") for i, each in enumerate((noise, *more))}
    return measure_lines(signals, DRIVE * rate / RATE, drive and drive * rate / RATE)


def test_the_noise_of_a_line_is_what_it_scatters_by() -> None:
    rng = np.random.default_rng(5)
    found = [lines(0.01 * rng.normal(size=COUNT)) for _ in range(40)]
    errors = np.array([each.lines[[0, 2], 0] - [1.0, 0.1] for each in found])
    parts = np.concatenate([errors.real, errors.imag]).ravel()
    told = np.mean([each.deviations[[0, 2], 0] for each in found])
    # Of white noise with a Hann window: sigma sqrt(2 * 1.5 / n).
    assert told == pytest.approx(0.01 * np.sqrt(3 / COUNT), rel=0.03)
    assert parts.std() == pytest.approx(told, rel=0.2)
    assert abs(parts.mean()) < 4 * told / np.sqrt(parts.size)


@pytest.mark.slow
def test_the_noise_is_known_as_well_as_its_freedom_says() -> None:
    rng = np.random.default_rng(9)
    found = [lines(0.01 * rng.normal(size=COUNT)) for _ in range(300)]
    powers = np.array([each.deviations[0, 0] ** 2 for each in found])
    # A chi-square of n degrees of freedom has a relative variance of 2/n.
    assert 2 * powers.mean() ** 2 / powers.var(ddof=1) == pytest.approx(found[0].freedom, rel=0.25)


def test_noise_follows_its_colour() -> None:
    from scipy.signal import lfilter

    rng = np.random.default_rng(6)
    found = lines(lfilter([0.01], [1, -0.9], rng.normal(size=COUNT)), rate=3.0 * RATE)
    angles = 2 * np.pi * found.frequencies / (3.0 * RATE)
    wanted = 0.01 * np.sqrt(3 / COUNT) / abs(1 - 0.9 * np.exp(-1j * angles))
    assert found.deviations[:, 0] == pytest.approx(wanted, rel=0.3)


def test_noise_that_two_outputs_share_counts_once() -> None:
    rng = np.random.default_rng(7)
    shared, own = rng.normal(size=(2, COUNT))
    found = lines(0.01 * shared, 0.01 * (shared + 0.1 * own))
    apart = np.tile(np.array([[1.0, 1.0], [1.0, -1.0]])[:, None], (1, 1, 1)).reshape(2, 2)
    together, against = (
        abs(np.linalg.solve(found.factors[0], each)) ** 2 for each in apart / np.linalg.norm(apart[0])
    )
    assert against.sum() > 100 * together.sum()


def test_the_drive_is_found() -> None:
    noise = 0.01 * np.random.default_rng(8).normal(size=COUNT)
    found = lines(noise, drive=None)
    assert found.found and found.frequency == pytest.approx(DRIVE, abs=2e-3)


def test_frequencies_that_are_found_scatter_as_is_told() -> None:
    made = (np.random.default_rng(seed).normal(size=COUNT) for seed in range(16))
    found = [lines(0.1 * noise, drive=None) for noise in made]
    told = np.mean([each.frequency_deviation for each in found])
    assert np.std([each.frequency for each in found]) == pytest.approx(told, rel=0.4)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        (DRIVE, []),
        (DRIVE + 1e-3, []),
        (50.2, ["the record's own lines are at multiples of 50.000"]),
        (51.3, ["the record's own lines are at multiples of 50.000"]),
        (25.0, ["all lines of the record are at multiples of 50 Hz"]),
        (30.0, ["the largest line of the record is at 50 Hz, no multiple of the drive"]),
    ],
)
def test_a_drive_that_is_given_is_doubted_where_the_record_has_another(given: float, told: list[str]) -> None:
    noise = 0.001 * np.random.default_rng(8).normal(size=COUNT)
    doubts = list(doubts_of(lines(noise, drive=given)))
    assert [doubt[: len(start)] for doubt, start in zip(doubts, told, strict=True)] == told
    assert all(f"is --drive {given:g} right?" in doubt for doubt in doubts)


def test_a_drive_that_was_found_is_not_doubted() -> None:
    noise = 0.001 * np.random.default_rng(8).normal(size=COUNT)
    assert not list(doubts_of(lines(noise, drive=None)))


def test_lines_between_the_harmonics_are_named() -> None:
    noise = 0.01 * np.random.default_rng(9).normal(size=COUNT)
    half = 0.05 * np.cos(2 * np.pi * 2.5 * DRIVE * TIMES)
    hum = 0.03 * np.cos(2 * np.pi * 71.3 * TIMES)
    found = lines(noise + half + hum)
    assert found.period_count == 2
    (stray,) = found.strays
    assert stray.fraction is None and stray.frequency == pytest.approx(71.3, abs=0.1)
    assert found.deviations[0, 0] == pytest.approx(0.01 * np.sqrt(3 / COUNT), rel=0.3)


def tone(order: float, size: complex = 1.0) -> np.ndarray:
    return np.asarray((size * np.exp(2j * np.pi * order * DRIVE * TIMES)).real)


def of(*values: np.ndarray, unit: str = "m", noise: float = 1e-3, samples: int = COUNT) -> MeasuredLines:
    """Lines of tones in noise."""
    rng = np.random.default_rng(3)
    signals = {
        f"s{i}": Signal((each + noise * rng.normal(size=COUNT))[:samples], RATE, f"s{i}", unit)
        for i, each in enumerate(values)
    }
    return measure_lines(signals, DRIVE, DRIVE)


def test_lines_up_to_a_quarter_beyond_the_last_that_is_seen_are_kept() -> None:
    found = of(tone(1), tone(1, 0.3j) + tone(9, 0.5))
    assert len(found.lines) == 12 + 2
    np.testing.assert_allclose(found.lines[[0, 8]], [[1.0, 0.3j], [0.0, 0.5]], atol=3e-4)
    assert (found.found, found.noiseless) == (False, False)
    assert (found.outputs, found.derivatives) == (("s0", "s1"), (0, 0))
    assert len(of(tone(1)).lines) == 4
    assert of(tone(1), noise=0.0).noiseless


@pytest.mark.parametrize(("rate", "count"), [(1013.0, 10), (1002.0, 9)])
def test_lines_up_to_what_the_window_leaves_below_half_the_rate_are_taken(rate: float, count: int) -> None:
    """A window's main lobe, 2 bins to either side, ends below half the rate: 0.5 rate (1 - 4 / samples)."""
    times = np.arange(1000) / rate
    values = np.cos(2 * np.pi * DRIVE * times) + 0.5 * np.cos(2 * np.pi * 9 * DRIVE * times)
    noisy = values + 1e-3 * np.random.default_rng(4).normal(size=1000)
    assert len(measure_lines({"s": Signal(noisy, rate, "s", "m")}, DRIVE, DRIVE).lines) == count


def test_lines_at_fractions_make_a_longer_period_where_the_record_has_enough() -> None:
    half = tone(1) + tone(1.5, 0.2j)
    found = of(half)
    assert (found.period_count, found.strays) == (2, ())
    assert found.lines[2, 0] == pytest.approx(0.2j, abs=3e-4)
    assert found.frequencies[:3] == pytest.approx([25.0, 50.0, 75.0])
    short = of(half, samples=920)
    assert (short.period_count, [each.fraction for each in short.strays]) == (1, [(3, 2)])


def test_units_are_those_of_the_system() -> None:
    found, micro = of(tone(1)), of(tone(1), unit="um")
    np.testing.assert_allclose(micro.lines, 1e-6 * found.lines, rtol=1e-9)
    assert micro.deviations == pytest.approx(1e-6 * found.deviations, rel=1e-6, abs=0.0)


SINE = np.cos(2 * np.pi * 50 * TIMES)
NOISE = np.random.default_rng(1).normal(size=COUNT)


@pytest.mark.parametrize(
    ("signals", "told"),
    [
        ({"a": Signal(SINE[:300], RATE, "a", "m")}, "7.5 periods of the drive.*measure"),
        ({"a": Signal(SINE, RATE, "a", "V")}, "does not tell whether it is a displ"),
        ({"a": Signal(SINE, 80.0, "a", "m")}, "show no drive at 50 Hz"),
        (
            {name: Signal(SINE[:end], RATE, name, "m") for name, end in (("a", 99), ("b", 199))},
            "unlike times",
        ),
        ({"a": Signal(NOISE, RATE, "a", "m")}, "no multiple of the drive at 50 Hz stands out of the noise"),
    ],
)
def test_records_that_cannot_be_used(signals: dict[str, Signal], told: str) -> None:
    for by_itself, what in ((False, "drive"), (True, "vibration")):
        with pytest.raises(SignalError, match=told.replace("drive", what)):
            measure_lines(signals, DRIVE, DRIVE, None, by_itself)
