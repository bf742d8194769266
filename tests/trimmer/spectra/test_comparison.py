"""Measured and simulated lines: known motions are aligned, and known differences are found."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.comparison import SimulatedLines, compare_motions, found_frequency

RATE = 5000.0
TIMES = np.arange(6000) / RATE
LINES = np.array([1e-3 * np.exp(0.4j), 2e-4j, 1e-4, -5e-5 + 1e-5j, 2e-5])
NOISE = np.random.default_rng(0).normal(size=TIMES.size)


def motion(
    frequency: float, lines: np.ndarray, derivatives: int = 0, delay: float = 0.0, count: int = 1
) -> np.ndarray:
    omega = 2 * np.pi * frequency / count * np.arange(1, lines.size + 1)
    return ((lines * (1j * omega) ** derivatives) @ np.exp(1j * np.outer(omega, TIMES - delay))).real


@pytest.mark.parametrize("derivatives", [0, 1, 2])
@pytest.mark.parametrize("delay", [0.0, 0.0031, 0.0088])
def test_a_motion_is_aligned_with_itself(derivatives: int, delay: float) -> None:
    unit = ("mm", "m/s", "m/s2")[derivatives]
    values = motion(110.0, LINES, derivatives, delay) * (1e3 if unit == "mm" else 1.0)
    compared = compare_motions(Signal(values, RATE, "a", unit), SimulatedLines(LINES, 110.0))
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


def test_differences_are_told_line_by_line_at_the_measured_frequency() -> None:
    changed = LINES * np.array([1.0, 2.0, 0.5, 1.0, 1.0])
    values = motion(111.3, changed) + 1e-6 * NOISE
    compared = compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(LINES, 110.0))
    assert compared.frequency == pytest.approx(111.3, rel=1e-5)
    np.testing.assert_allclose(compared.decibels, [0.0, 6.02, -6.02, 0.0, 0.0], atol=0.05)
    assert compared.rest == pytest.approx(1e-6, rel=0.05)
    assert compared.uncertainty == pytest.approx(1e-6 * np.sqrt(1.5 * 2 / TIMES.size), rel=0.05)


def test_the_uncertainty_is_that_of_repeated_trials() -> None:
    rng = np.random.default_rng(1)
    clean = motion(110.0, LINES)
    compared = [
        compare_motions(
            Signal(clean + 1e-4 * rng.normal(size=clean.size), RATE, "x", "m"),
            SimulatedLines(LINES, 110.0),
            110.0,
        )
        for _ in range(30)
    ]
    scatter = np.std([abs(each.measured) for each in compared], axis=0)
    assert scatter.mean() == pytest.approx(compared[0].uncertainty, rel=0.2)


def test_subharmonics_are_lines_too() -> None:
    lines = np.array([1e-4, 1e-3, 0.0, 2e-4j, 3e-5, 1e-4])
    values = motion(110.0, lines, delay=0.011, count=2)
    compared = compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(lines, 110.0, 2))
    assert compared.frequencies[:2].tolist() == pytest.approx([55.0, 110.0], rel=1e-6)
    assert compared.shift == pytest.approx(0.011, abs=1e-7)
    assert compared.residual < 1e-4
    velocity = Signal(1e3 * motion(110.0, lines, 1, 0.011, 2), RATE, "v", "mm/s")
    compared = compare_motions(velocity, SimulatedLines(lines, 110.0, 2))
    assert compared.residual < 1e-4
    assert compared.signal.unit == "m/s"
    assert compared.signal.values == pytest.approx(1e-3 * velocity.values)


def test_a_sensor_that_is_mounted_the_other_way_round_is_noticed() -> None:
    values = motion(110.0, LINES, delay=0.002)
    assert not compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(LINES, 110.0)).opposite
    turned = compare_motions(Signal(-values, RATE, "x", "m"), SimulatedLines(LINES, 110.0))
    assert turned.opposite
    assert turned.inverted_residual < 1e-4 < turned.residual


def test_scale_of_both_does_not_matter_and_a_scale_of_one_shows_in_each_line() -> None:
    signal = Signal(motion(110.0, 3.0 * LINES), RATE, "x", "m")
    compared = compare_motions(signal, SimulatedLines(LINES, 110.0))
    np.testing.assert_allclose(compared.decibels, 20 * np.log10(3.0), atol=1e-3)
    assert compared.residual == pytest.approx(2 / 3, rel=1e-4)


def test_lines_are_compared_as_far_as_the_measurement_shows_them() -> None:
    signal = Signal(motion(110.0, LINES)[::10], RATE / 10, "x", "m")
    assert compare_motions(signal, SimulatedLines(LINES[:2], 110.0)).measured.size == 2
    assert compare_motions(signal, SimulatedLines(LINES, 110.0), 110.0).measured.size == 2


def test_what_cannot_be_compared_is_refused() -> None:
    with pytest.raises(SignalError, match="no line of the measurement is within 3 %"):
        compare_motions(Signal(motion(150.0, LINES[:1]), RATE, "x", "m"), SimulatedLines(LINES, 110.0))
    with pytest.raises(SignalError, match="does not tell whether it is a displacement"):
        compare_motions(Signal(NOISE, RATE, "x", "V"), SimulatedLines(LINES, 110.0))
    with pytest.raises(SignalError, match="show no drive at 4000 Hz"):
        compare_motions(Signal(NOISE, RATE, "x", "m"), SimulatedLines(LINES, 110.0), 4000.0)
    with pytest.raises(SignalError, match="displacement must be finite"):
        SimulatedLines(np.array([np.nan]), 110.0)


def test_the_largest_of_several_lines_near_the_drive_is_the_drive() -> None:
    values = motion(110.0, LINES[:1]) + motion(107.3, 0.2 * LINES[:1])
    found = found_frequency(Signal(values, RATE, "x", "m"), SimulatedLines(LINES[:1], 109.0))
    assert found == pytest.approx(110.0, abs=0.05)


def test_the_drive_of_a_long_record_is_found_to_a_millionth_of_a_hertz() -> None:
    times = np.arange(2000) / 20.0
    signal = Signal(np.cos(2 * np.pi * 2.00437 * times + 0.4), 20.0, "x", "m")
    assert found_frequency(signal, SimulatedLines([1.0], 2.0)) == pytest.approx(2.00437, abs=1e-6)


def test_a_record_shorter_than_two_periods_is_refused() -> None:
    signal = Signal(NOISE[:20], RATE, "x", "m")
    with pytest.raises(SignalError, match=r"the record lasts 0\.004 s"):
        compare_motions(signal, SimulatedLines(np.ones(90), 110.0), 110.0)
