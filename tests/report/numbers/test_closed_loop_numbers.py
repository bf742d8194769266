"""The numbers of section 5.2 that rest on simulation, beside SciPy and closed forms."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from report.numbers.drive_amplitudes import other_line
from report.numbers.listed_blocks import inertia_block
from report.numbers.record import Record, largest_peaks
from report.numbers.relay_loop import STEP, output_at_jump
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from trimmer import Drive, TrimmerParameters, pin_model
from trimmer.linear import InputChannels

DRIVE = Drive(DRIVE_AMPLITUDE, 2 * math.pi * DRIVE_FREQUENCY)


@pytest.fixture(scope="module")
def closed(evidence):
    return evidence.motion.closed


@pytest.fixture(scope="module")
def system():
    return pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)


def matrices(system):
    return system.A, system.B[:, 0], system.C[0]


def test_other_line_is_no_multiple_of_the_drive():
    times = np.arange(5000) / 1e4
    both = np.sin(2 * math.pi * 100 * times) + 0.3 * np.sin(2 * math.pi * 733.4 * times)
    frequency, amplitude = other_line(both, 1e4, 100.0)
    assert frequency == pytest.approx(733.4, abs=1e-6)
    assert amplitude == pytest.approx(0.3, rel=1e-6)
    frequency, amplitude = other_line(np.sin(2 * math.pi * 300 * times), 1e4, 100.0)
    assert math.isnan(frequency)
    assert amplitude == 0


def test_listings_block_in_the_loop_by_integration(closed, system):
    """The same loop with the listing's own function, integrated with small steps."""
    A, B, C = matrices(system)
    block = closed.timed_block

    def rate(t, x):
        pin = DRIVE.amplitude * math.sin(DRIVE.omega * t) - C @ x
        return A @ x + B * inertia_block(np.array([pin]), np.array([t]))[0]

    run = solve_ivp(rate, (0, 0.005), np.zeros(8), method="RK45", max_step=4e-6, t_eval=[0.001, 0.003, 0.005])
    expected = np.interp(run.t, block.times, block.block_in_loop)
    assert np.abs(C @ run.y - expected).max() < 1e-3 * np.abs(block.block_in_loop).max()


def test_number_of_samples_that_gives_the_printed_digits():
    """The range that the module states: both peaks round to 736.993 and 369.996."""
    fits = [
        samples
        for samples in (98_266, 98_267, 100_001, 105_714, 105_715)
        if (f"{Record(1.0, samples).frequency(737):.3f}", f"{Record(1.0, samples).frequency(370):.3f}")
        == ("736.993", "369.996")
    ]
    assert fits == [98_267, 100_001, 105_714]


def test_square_waves_zeros_by_summing_harmonics(system):
    A, B, C = matrices(system)
    orders = np.arange(1, 4001, 2)
    for frequency in (100.0, 222.0, 740.0, 5000.0):
        omega = 2 * math.pi * frequency
        gains = np.array([C @ np.linalg.solve(1j * n * omega * np.eye(8) - A, B) for n in orders])
        series = 4 / math.pi * np.sum(gains.imag / orders)
        (closed_form,) = output_at_jump(A, B, C, np.array([0.5 / frequency]))
        assert closed_form == pytest.approx(series, rel=1e-5, abs=1e-9)


def test_a_relay_looked_at_once_a_step_oscillates_by_its_delay(closed, system):
    """The delay is between zero and a step, and makes up for the lead of G; the size is that of a relay."""
    A, B, C = matrices(system)
    frequency, amplitude = closed.relay.sampled
    omega = 2 * math.pi * frequency
    response = C @ np.linalg.solve(1j * omega * np.eye(8) - A, B)
    lead = math.pi + math.atan2(response.imag, response.real)
    assert 0 < lead / omega < STEP
    assert amplitude == pytest.approx(4 / math.pi * abs(response), rel=0.05)


def test_records_hold_both_ends():
    record = Record(0.1, 1_000_231)
    assert record.bin_width == pytest.approx(10002300 / 1000231, rel=1e-12)
    assert record.nearest(733.568) == pytest.approx(729.9992702)
    assert Record(1.0, 1_000_231).nearest(733.568) == pytest.approx(733.9992662)
    assert largest_peaks(np.array([0, 1, 0, 3, 0, 2, 0.0]), 2) == (3, 5)
