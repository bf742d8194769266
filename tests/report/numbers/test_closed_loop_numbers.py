"""The numbers of section 5.2 that rest on simulation, beside SciPy and closed forms."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from report.numbers.drive_amplitudes import AMPLITUDES, other_line, reference_loop
from report.numbers.exact_orbits import orbit_by_durations
from report.numbers.impulse_response import events_by_integration
from report.numbers.listed_blocks import inertia_block
from report.numbers.record import Record, largest_peaks, line_amplitudes
from report.numbers.relay_loop import STEP, output_at_jump
from report.numbers.released_bodies import RECORD
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LARGE_GAP
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.loops.drive import Drive
from trimmer.loops.loops import ClosedLoop
from trimmer.loops.simulation import simulate_loop as simulate
from trimmer.parameters import TrimmerParameters

DRIVE = Drive(DRIVE_AMPLITUDE, 2 * math.pi * DRIVE_FREQUENCY)


@pytest.fixture(scope="module")
def closed(evidence):
    return evidence.motion.closed


@pytest.fixture(scope="module")
def system():
    return pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)


def matrices(system):
    return system.A, system.B[:, 0], system.C[0]


@pytest.mark.parametrize("name", ["friction", "friction_both_channels", "inertia"])
@pytest.mark.parametrize("which", ["stable", "unstable"])
def test_orbits_agree_with_the_solution_for_two_durations(closed, name, which):
    orbit = getattr(getattr(closed.orbits, name), which)
    amplitude, frequency = orbit_by_durations(orbit, inertia=name == "inertia")
    assert frequency == pytest.approx(orbit.frequency, rel=1e-11)
    if name != "inertia":
        assert amplitude == pytest.approx(orbit.amplitude, rel=1e-11)


def test_motions_leave_the_unstable_orbit_by_their_side(closed):
    inside, outside = closed.orbits.left_by
    assert inside < 1e-6
    assert outside == pytest.approx(closed.orbits.friction.stable.amplitude, rel=1e-5)


@pytest.mark.parametrize("factor", [0.999, 1.001])
def test_threshold_of_the_impulse_by_integration(closed, system, factor):
    impulse, duration = factor * closed.impulses.threshold, 0.02
    motion = simulate(ClosedLoop(system, FrictionBacklash(1.0)), duration, impulse=impulse)
    assert events_by_integration(system, impulse, duration) == len(motion.events)
    assert (len(motion.events) > 20) == (factor > 1)


def test_impulses_have_one_threshold_and_gaps_scale(closed):
    numbers = closed.impulses
    assert numbers.one_threshold
    for run in numbers.runs:
        goes_on = run.impulse > numbers.threshold * run.gap
        assert (run.amplitude > run.gap / 2) == goes_on
        if goes_on:
            assert run.amplitude / run.gap == pytest.approx(closed.orbits.friction.stable.amplitude, rel=1e-3)


def test_loop_with_a_reference_by_integration(system):
    """SciPy follows the same loop from event to event."""
    A, B, C = matrices(system)
    duration = 0.006
    motion = simulate(reference_loop(system, FrictionBacklash(LARGE_GAP), DRIVE), duration)

    def pin(t, x):
        return DRIVE.amplitude * math.sin(DRIVE.omega * t) - C @ x

    def rate(t, x, side, bridge):
        return A @ x + B * (pin(t, x) - side * LARGE_GAP / 2 if side else bridge)

    def leaving(t, x, side, bridge):
        velocity = DRIVE.amplitude * DRIVE.omega * math.cos(DRIVE.omega * t) - C @ rate(t, x, side, bridge)
        return side * velocity

    def upper(t, x, side, bridge):
        return LARGE_GAP / 2 - (pin(t, x) - bridge)

    def lower(t, x, side, bridge):
        return LARGE_GAP / 2 + (pin(t, x) - bridge)

    for event in (leaving, upper, lower):
        event.terminal, event.direction = True, -1
    state, time, bridge, side = np.zeros(8), 0.0, 0.0, 0
    while time < duration:
        run = solve_ivp(
            rate,
            (time, duration),
            state,
            method="DOP853",
            rtol=1e-10,
            atol=1e-14,
            max_step=5e-5,
            events=[leaving] if side else [upper, lower],
            args=(side, bridge),
        )
        time, state = run.t[-1], run.y[:, -1]
        if run.status == 1 and side:
            bridge, side = pin(time, state) - side * LARGE_GAP / 2, 0
        elif run.status == 1:
            side = 1 if run.t_events[0].size else -1
    assert len(motion.events) > 8
    assert C @ state == pytest.approx(float(motion.output(duration)), rel=1e-6)


def test_reference_puts_out_the_limit_cycle_when_it_is_strong(closed):
    reference, orbit = closed.reference, closed.orbits.friction.stable
    weak, *_ = reference.from_limit_cycle
    assert weak.line == pytest.approx(LARGE_GAP * abs(orbit.harmonics[0]), rel=1e-4)
    assert weak.frequency == pytest.approx(orbit.frequency, rel=1e-6)
    assert [run.amplitude for run in reference.from_limit_cycle] == list(AMPLITUDES)
    assert [run.line > 0 for run in reference.from_limit_cycle] == [True, True, True, False, False]
    assert reference.both_channels.line == 0
    assert reference.from_rest.line == pytest.approx(reference.from_limit_cycle[2].line, rel=1e-4)


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


def test_open_loop_repeats_with_the_drive_and_has_odd_harmonics(closed):
    block = closed.timed_block
    assert block.repeat < 1e-8
    assert block.harmonics[2:40:2].max() < 1e-8 * block.harmonics[1]
    assert block.harmonics[7] > 1e-3 * block.harmonics[1]


def test_the_fifth_harmonic_of_the_experiments_drive_outweighs_the_line_at_659_hertz(closed, system):
    """Six times 109.845 Hz is 659 Hz, but five times it meets a natural mode."""
    omega = 2 * math.pi * 109.845
    element = InertiaBacklash(4e-4).describing_function(DRIVE_AMPLITUDE, omega, harmonic=5)
    fifth = DRIVE_AMPLITUDE * abs(complex(element) * complex(system(5j * omega)))
    amplitudes = line_amplitudes(closed.timed_block.block_in_loop)
    assert fifth > 4 * amplitudes[66]


def test_released_bodies_show_the_modes_of_the_linear_loop(closed, system):
    A, B, C = matrices(system)
    step = expm((A - np.outer(B, C)) * RECORD.duration / (RECORD.samples - 1))
    state, output = np.repeat([1.0, 0.0], 4), np.empty(RECORD.samples)
    for place in range(RECORD.samples):
        output[place] = C @ state
        state = step @ state
    linear = tuple(sorted(largest_peaks(line_amplitudes(output), 3)))
    for run in closed.released_bodies.runs:
        assert run.peaks == linear
        assert run.left < 1e-12 * run.displacement
    frequencies = [RECORD.frequency(number) for number in linear]
    np.testing.assert_allclose(frequencies, closed.released_bodies.modes[:3], rtol=2e-3)


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


def test_relay_swings_shrink_at_the_rate_of_the_markov_parameters(closed):
    relay = closed.relay
    for run in relay.runs:
        assert run.growth == pytest.approx(relay.damping / 3, rel=1e-3)
        assert run.swings[-1] < run.swings[: run.swings.size // 2].min()
    assert all(relay.alone.in_phase)
    assert all(relay.with_viscous.in_phase)
    assert all(run.last_turn < 1e-3 for run in relay.friction)


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
