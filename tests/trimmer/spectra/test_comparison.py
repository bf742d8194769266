"""Measured and simulated lines: known motions are aligned, and known differences are found."""

import numpy as np
import pytest

from trimmer.errors import WrongTypeError
from trimmer.signals import Band, Signal, SignalError
from trimmer.spectra import SimulatedLines, compare_motions
from trimmer.spectra.comparison import found_frequency

RATE = 5000.0
TIMES = np.arange(6000) / RATE
LINES = np.array([1e-3 * np.exp(0.4j), 2e-4j, 1e-4, -5e-5 + 1e-5j, 2e-5])
NOISE = np.random.default_rng(0).normal(size=TIMES.size)


def motion(frequency, lines, derivatives: int = 0, delay: float = 0.0, count: int = 1) -> np.ndarray:
    omega = 2 * np.pi * frequency / count * np.arange(1, lines.size + 1)
    return ((lines * (1j * omega) ** derivatives) @ np.exp(1j * np.outer(omega, TIMES - delay))).real


@pytest.mark.parametrize(
    ("derivatives", "unit", "own"),
    [(0, "mm", "m"), (1, "m/s", "m"), (2, "m/s2", "m"), (1, "m/s2", "m/s"), (0, "N", "N")],
)
@pytest.mark.parametrize("delay", [0.0, 0.0031, 0.0088])
def test_a_motion_is_aligned_with_itself(derivatives: int, unit: str, own: str, delay: float) -> None:
    values = motion(110.0, LINES, derivatives, delay) * (1e3 if unit == "mm" else 1.0)
    compared = compare_motions(Signal(values, RATE, "a", unit), SimulatedLines(LINES, 110.0, unit=own))
    assert compared.frequency == pytest.approx(110.0, rel=1e-6)
    assert compared.shift == pytest.approx(delay % (1 / 110.0), abs=1e-7) or compared.shift > 1 / 110.0 - 1e-7
    assert compared.residual < 1e-4
    np.testing.assert_allclose(compared.decibels, 0.0, atol=1e-3)
    np.testing.assert_allclose(compared.phase_differences, 0.0, atol=1e-3)
    times, measured, simulated = compared.waveforms(100)
    np.testing.assert_allclose(measured, simulated, atol=1e-3 * np.abs(measured).max())
    omega = 2 * np.pi * 110.0 * np.arange(1, 6)
    exact = ((LINES * (1j * omega) ** derivatives) @ np.exp(1j * np.outer(omega, times - delay))).real
    np.testing.assert_allclose(measured, exact, atol=1e-3 * np.abs(exact).max())


def test_the_uncertainty_is_that_of_repeated_trials() -> None:
    rng = np.random.default_rng(1)
    clean = motion(110.0, LINES)
    trials = [Signal(clean + 1e-4 * rng.normal(size=clean.size), RATE, "x", "m") for _ in range(30)]
    compared = [compare_motions(each, SimulatedLines(LINES, 110.0), 110.0) for each in trials]
    scatter = np.std([abs(each.measured) for each in compared], axis=0)
    assert scatter.mean() == pytest.approx(compared[0].uncertainty, rel=0.2)


def test_subharmonics_are_lines_too() -> None:
    lines = np.array([1e-4, 1e-3, 0.0, 2e-4j, 3e-5, 1e-4])
    values = motion(110.0, lines, delay=0.011, count=2)
    compared = compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(lines, 110.0, 2))
    assert compared.frequencies[:2].tolist() == pytest.approx([55.0, 110.0], rel=1e-6)
    assert compared.shift == pytest.approx(0.011, abs=1e-7)
    assert compared.residual < 1e-4


def test_a_sensor_that_is_mounted_the_other_way_round_is_noticed() -> None:
    values = motion(110.0, LINES, delay=0.002)
    assert not compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(LINES, 110.0)).opposite
    turned = compare_motions(Signal(-values, RATE, "x", "m"), SimulatedLines(LINES, 110.0))
    assert turned.opposite
    assert turned.inverted_residual < 1e-4 < turned.residual


def test_what_cannot_be_compared_is_refused() -> None:
    with pytest.raises(SignalError, match=r"the record lasts 0\.004 s"):
        compare_motions(Signal(NOISE[:20], RATE, "x", "m"), SimulatedLines(np.ones(90), 110.0), 110.0)
    with pytest.raises(SignalError, match="no line of the measurement is within 3 %"):
        compare_motions(Signal(motion(150.0, LINES[:1]), RATE, "x", "m"), SimulatedLines(LINES, 110.0))
    with pytest.raises(SignalError, match="does not tell whether it is a displacement"):
        compare_motions(Signal(NOISE, RATE, "x", "V"), SimulatedLines(LINES, 110.0))
    with pytest.raises(SignalError, match="the output is in N, and the signal in 'V'; give it in N"):
        compare_motions(Signal(NOISE, RATE, "x", "V"), SimulatedLines(LINES, 110.0, unit="N"))
    with pytest.raises(SignalError, match="show no drive at 4000 Hz"):
        compare_motions(Signal(NOISE, RATE, "x", "m"), SimulatedLines(LINES, 110.0), 4000.0)
    with pytest.raises(SignalError, match="show no vibration at 4000 Hz"):
        compare_motions(Signal(NOISE, RATE, "x", "m"), SimulatedLines(LINES, 110.0, by_itself=True), 4000.0)
    with pytest.raises(SignalError, match="displacement must be finite"):
        SimulatedLines(np.array([np.nan]), 110.0)


def test_lines_are_compared_one_by_one() -> None:
    """3 cos x - 4 sin 2x was measured, 3 cos x + 2 cos 2x simulated."""
    measured, simulated = np.array([3.0, 4j]), np.array([3.0, 2.0])
    signal = Signal(motion(110.0, measured), RATE, "x", "m")
    both = compare_motions(signal, SimulatedLines(simulated, 110.0), 110.0)
    turn = np.exp(1j * np.array([1, 2]) * np.angle(both.simulated[0]))
    assert both.decibels == pytest.approx([0.0, 20.0 * np.log10(2.0)])
    assert both.frequencies.tolist() == [110.0, 220.0]
    np.testing.assert_allclose(np.abs(both.simulated), simulated)
    np.testing.assert_allclose(both.simulated, simulated * turn, atol=1e-9)
    assert both.residual == pytest.approx(np.linalg.norm(both.measured - both.simulated) / 5.0)
    # No other shift of the simulation leaves less.
    angles = np.linspace(0.0, 2.0 * np.pi, 20_001)
    shifted = simulated * np.exp(-1j * np.outer(angles, [1, 2]))
    least = np.linalg.norm(measured - shifted, axis=1).min() / 5.0
    assert both.residual == pytest.approx(least, abs=1e-6)
    angle = angles[np.linalg.norm(measured - shifted, axis=1).argmin()]
    assert both.shift == pytest.approx(angle / (2 * np.pi * 110.0), abs=1e-6)
    inverted = np.linalg.norm(measured + shifted, axis=1).min() / 5.0
    assert both.inverted_residual == pytest.approx(inverted, abs=1e-6)
    times, curve, other = both.waveforms(4)
    assert times == pytest.approx(both.period * np.arange(4) / 4)
    assert curve == pytest.approx([3.0, 0.0, -3.0, 0.0], abs=1e-9)
    quarters = np.exp(1j * np.outer([1, 2], 0.5 * np.pi * np.arange(4)))
    assert other == pytest.approx((both.simulated @ quarters).real)
    row = [220.0, 4.0, 2.0, both.decibels[1], both.phase_differences[1]]
    assert both.to_dataframe().iloc[1].tolist() == pytest.approx(row)
    assert f"2 lines at 110 Hz, difference {100 * both.residual:.5g}% rms" in repr(both)


@pytest.mark.parametrize(
    ("band", "lines", "count", "fitted"),
    [(Band(), 90, 1, 9), (Band(0.0, 430.0), 90, 1, 4), (Band(), 3, 1, 3), (Band(), 5, 2, 5)],
)
def test_no_more_lines_are_compared_than_the_measurement_shows(band, lines, count, fitted: int) -> None:
    """Hann's lobe of 2 of 400 samples at 2000 Hz: up to 995 Hz."""
    signal = Signal(np.random.default_rng(2).normal(size=400), 2000.0, "x", "m", trusted=band)
    compared = compare_motions(signal, SimulatedLines(np.ones(lines), 100.0, count), 100.0)
    assert compared.measured.size == fitted
    assert compared.period == pytest.approx(count / 100.0)


def test_a_drive_is_found_within_three_percent_and_must_explain_the_motion() -> None:
    long = Signal(np.cos(2 * np.pi * 2.00437 * np.arange(2000) / 20.0 + 0.4), 20.0, "x", "m")
    assert found_frequency(long, SimulatedLines([1.0], 2.0)) == pytest.approx(2.00437, abs=1e-6)
    lines = np.array([1e-3, 2e-4j])
    signal = Signal(motion(100.0, 2 * lines), RATE, "x", "m")
    assert found_frequency(signal, SimulatedLines(lines, 102.9)) == pytest.approx(100.0, rel=1e-6)
    with pytest.raises(SignalError, match="no line of the measurement"):
        found_frequency(signal, SimulatedLines(lines, 103.2))
    # The second harmonic, when it is the largest, is one of the drive too.
    second = Signal(motion(100.0, lines * [0.1, 2.0]), RATE, "x", "m")
    assert found_frequency(second, SimulatedLines(lines, 101.0)) == pytest.approx(100.0, rel=1e-5)
    noisy = Signal(motion(100.0, lines) + motion(700.0, 5.0 * lines[:1]), RATE, "x", "m")
    with pytest.raises(SignalError, match="explain only"):
        found_frequency(noisy, SimulatedLines(lines[:1], 101.0))
    turned = compare_motions(signal, SimulatedLines(lines, 101.0), 100.0)
    assert (turned.found, turned.simulated_frequency, turned.period_count) == (False, 101.0, 1)
    assert turned.residual == pytest.approx(0.5)
    # -(cos a + 0.04 cos 2a) is at most 0.96: of the squares 4.16 + 1.04 - 4 0.96 are left.
    assert turned.inverted_residual == pytest.approx(np.sqrt(1.36 / 4.16), rel=1e-9)


def test_a_vibration_by_itself_is_looked_for_about_the_largest_line_that_is_to_be_trusted() -> None:
    lines = np.array([1e-3, 0.9e-3])
    hum = Signal(motion(100.0, lines) + motion(13.0, 1.05 * lines[:1]), RATE, "x", "m", trusted=Band(50.0))
    for simulated in (70.0, 130.0):
        found = found_frequency(hum, SimulatedLines(lines, simulated, by_itself=True))
        assert found == pytest.approx(100.0, rel=1e-4)


def test_simulated_lines_are_complex_numbers_in_a_row() -> None:
    assert "2 lines at 1/4 of 3 Hz" in repr(SimulatedLines(np.array([1.0, 2.0]), 3.0, 4))
    for wrong in ([], [[1.0]], [1, 2], [np.inf], ["a"], [[1.0], [1.0, 2.0]]):
        with pytest.raises(SignalError, match="one dimension"):
            SimulatedLines(wrong, 3.0)
    for options, told in (((-3.0,), "frequency must be positive"), ((3.0, 0), "period_count")):
        with pytest.raises(ValueError, match=told):
            SimulatedLines([1.0], *options)
    with pytest.raises(WrongTypeError, match="simulated"):
        compare_motions(Signal(NOISE, RATE, "x", "m"), np.ones(3))  # type: ignore[arg-type]
