"""Where the search for an orbit begins: phase, mode, state and sizes of the first guess."""

from __future__ import annotations

import math

import control
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize

from trimmer import (
    ClosedLoop,
    CoulombFriction,
    DeadZone,
    FrictionBacklash,
    InertiaBacklash,
    Preload,
    Relay,
    Saturation,
    ViscousBacklash,
    ViscousFriction,
)
from trimmer.motion.backlash_component import FREE, LOWER, UPPER
from trimmer.motion.components_of_elements import components_of
from trimmer.motion.corner_component import ABOVE, BELOW, BETWEEN
from trimmer.motion.relay_component import MINUS, PLUS
from trimmer.motion.threshold_component import NEGATIVE, POSITIVE, SILENT
from trimmer.orbits.balanced_start import _of_load, _quiet_phases, _start, balanced_starts
from trimmer.orbits.guess import _events, _farthest_from_events, _leaves, _mode, _quiet_phase, starting_point
from trimmer.orbits.initial_states import _rates, _scales, initial_states, quiet_time
from trimmer.orbits.steady_response import Flight, flight_of, steady_response, switch_of
from trimmer.orbits.trigonometric import OddPolynomial

PI = math.pi
PLANT = control.ss([[0.0, 1.0], [-40.0, -1.2]], [[0.3], [2.0]], [[1.0, 0.1]], [[0.0]])
"""x'' as of an oscillator with another column, so that no two entries are alike."""
AMPLITUDE, OMEGA = 3.0, 7.0


def steady_states(loop: ClosedLoop, output: complex, phase: float) -> np.ndarray:
    """State of the linear system under Im(output exp(j x)) at a phase, from the flow over a period.

    The sinusoid is made by an oscillator beside the system: z = exp(j x).
    """
    A, B = loop.model.A, loop.model.B
    both = np.zeros((4, 4))
    both[:2, :2], both[2:, 2:] = A, [[0.0, -OMEGA], [OMEGA, 0.0]]
    both[:2, 2:] = B @ [[output.imag, output.real]]
    oscillator = np.array([math.cos(phase), math.sin(phase)])
    flow = scipy.linalg.expm(both * 2 * PI / OMEGA)
    return np.linalg.solve(np.eye(2) - flow[:2, :2], flow[:2, 2:] @ oscillator)


@pytest.mark.parametrize("element", [Relay(1.5), FrictionBacklash(0.8), -3.0 * Saturation(1.0, 2.0)])
def test_the_guess_is_the_steady_motion_under_the_first_harmonic(element) -> None:
    loop = ClosedLoop(PLANT, element)
    start = starting_point(loop, AMPLITUDE, OMEGA)
    output = AMPLITUDE * complex(element.describing_function(AMPLITUDE, OMEGA))
    phase = _quiet_phase(_leaves(element), AMPLITUDE, OMEGA)
    np.testing.assert_allclose(start.state[:2], steady_states(loop, output, phase), rtol=1e-9)
    now, later = (steady_states(loop, output, each) for each in (0.0, PI / 2))
    np.testing.assert_allclose(start.sizes[:2], np.hypot(now, later), rtol=1e-9)
    assert start.state[-1] == 1.0
    assert start.sizes[-1] == 1.0


def test_the_guess_begins_in_contact_with_a_load_that_moves_like_the_pin() -> None:
    loop = ClosedLoop(PLANT, InertiaBacklash(0.8))
    start = starting_point(loop, AMPLITUDE, OMEGA)
    assert loop.modes.component_modes(start.mode) == (UPPER,)
    first = loop.modes.layout.first_states[0]
    assert start.sizes[first : first + 2].tolist() == [AMPLITUDE, AMPLITUDE * OMEGA]
    slowing = starting_point(ClosedLoop(PLANT, ViscousBacklash(0.8, 0.1)), AMPLITUDE, OMEGA)
    assert slowing.sizes[first : first + 2].tolist() == [AMPLITUDE, AMPLITUDE * OMEGA]


def test_leaves_are_the_elements_of_the_components() -> None:
    backlash, friction, preload = FrictionBacklash(1.0), CoulombFriction(2.0), Preload(1.0, 2.0)
    element = 2.0 * backlash + (-3.0) * (friction + preload)
    leaves = _leaves(element)
    assert leaves == [backlash, friction, preload, preload]
    assert len(list(components_of(element))) == len(leaves)


def test_events_are_where_the_input_passes_thresholds() -> None:
    sixth = PI / 6
    expected = pytest.approx([sixth, 5 * sixth, 7 * sixth, 11 * sixth])
    assert _events(Saturation(1.5, 7.0), 3.0) == expected
    assert _events(DeadZone(1.5, 7.0), 3.0) == expected
    on, off = math.asin(0.5), PI - math.asin(0.1)
    relay = Relay(2.0, 0.6, 0.9)  # on at 1.5, off at 0.3
    assert _events(relay, 3.0) == pytest.approx([on, off, on + PI, off + PI])
    for leaf, amplitude in ((relay, 1.5), (Saturation(1.5, 7.0), 1.5), (Relay(2.0), 3.0)):
        assert _events(leaf, amplitude) == []


def test_the_phase_farthest_from_events() -> None:
    assert _farthest_from_events([]) == PI / 4
    assert _farthest_from_events([0.5, 3.0, 1.0]) == pytest.approx((3.0 + 0.5 + 2 * PI) / 2)
    assert _farthest_from_events([0.5, 4.5, 1.0 - 2 * PI]) == pytest.approx(2.75)
    assert _farthest_from_events([6.0, 1.0]) == pytest.approx(3.5)


def test_the_quiet_phase_is_the_middle_of_the_first_contact() -> None:
    # The pin meets the upper side where sin x = -1 + gap / amplitude, and leaves it at pi/2.
    backlash = FrictionBacklash(1.2)
    middle = 0.5 * (math.asin(-0.6) + PI / 2)
    step = 2 * PI / 719
    assert _quiet_phase([Relay(1.0), backlash], 3.0, 5.0) == pytest.approx(middle, abs=step)
    # Of an even number of phases in contact it is the first after the middle.
    grid = np.linspace(-PI, PI, 720)
    inside = grid[(grid > math.asin(-0.19)) & (grid < PI / 2)]
    assert len(inside) % 2 == 0
    assert _quiet_phase([FrictionBacklash(2.43)], 3.0, 5.0) == inside[len(inside) // 2]
    assert _quiet_phase([Relay(1.0)], 3.0, 5.0) == PI / 4
    assert _quiet_phase([Saturation(1.5, 1.0)], 3.0, 5.0) in (
        pytest.approx(PI / 2),
        pytest.approx(3 * PI / 2),
    )


PHASES = [0.2, PI / 2 + 0.2, PI + 0.2, 3 * PI / 2 + 0.2]
MODES = [
    (Relay(1.0), [PLUS, PLUS, MINUS, MINUS]),
    (CoulombFriction(1.0), [PLUS, MINUS, MINUS, PLUS]),
    (FrictionBacklash(1.2), [UPPER, FREE, LOWER, FREE]),
    (Saturation(2.0, 1.0), [BETWEEN, ABOVE, BETWEEN, BELOW]),
    (Relay(1.0, 0.3, 1.7), [SILENT, POSITIVE, SILENT, NEGATIVE]),
    (ViscousFriction(1.0), [0, 0, 0, 0]),
]


@pytest.mark.parametrize(("element", "modes"), MODES)
def test_the_mode_at_a_phase(element, modes: list[int]) -> None:
    ((component, _),) = components_of(element)
    assert [_mode(component, element, phase, 3.0, 5.0) for phase in PHASES] == modes


def test_contact_is_told_from_flight_in_a_gap_of_any_size() -> None:
    backlash = FrictionBacklash(4e-5)
    ((component, _),) = components_of(backlash)
    modes = [_mode(component, backlash, phase, 1e-4, 691.0) for phase in PHASES]
    assert modes == [UPPER, FREE, LOWER, FREE]
    middle = 0.5 * (math.asin(-0.6) + PI / 2)
    assert _quiet_phase([backlash], 1e-4, 691.0) == pytest.approx(middle, abs=2 * PI / 719)


def test_a_flight_gives_place_velocity_and_what_is_left_of_it() -> None:
    flight = Flight(1.0, 2.5, lambda phase: 3.0 - 2.0 * (phase - 1.0))
    share = math.exp(-0.6 / (691.0 * 0.01))
    for turns, sign, side in ((0, 1.0, LOWER), (1, -1.0, UPPER), (2, 1.0, LOWER), (-1, -1.0, UPPER)):
        mode, states = _of_load(flight, 691.0, 1.6 + turns * PI, 0.01)
        assert mode == FREE
        assert states == pytest.approx([sign * 1.8, sign * -2 * 691.0, share], rel=1e-9)
        mode, states = _of_load(flight, 691.0, 3.0 + turns * PI, 0.01)
        assert (mode, states.tolist()) == (side, [0.0, 0.0, 1.0])
    assert _of_load(flight, 691.0, 1.6, 0.0)[1][2] == 0.0
    assert _of_load(flight, 691.0, 1.6, math.inf)[1][2] == 1.0


def test_a_relay_switches_where_its_input_or_the_rate_of_that_falls_through_zero() -> None:
    given = OddPolynomial(np.array([2.0 * np.exp(0.4j)]))
    relay, friction = (components_of(each)[0][0] for each in (Relay(1.0), CoulombFriction(1.0)))
    assert switch_of(relay, given) == pytest.approx(PI - 0.4)
    assert switch_of(friction, given) == pytest.approx(PI / 2 - 0.4)
    assert switch_of(relay, OddPolynomial(np.zeros(1, dtype=complex))) is None
    # Of several falls in a period it is the first from an eighth before the first harmonic rises.
    for turn in (0.0, 1.0, -2.5):
        twice = OddPolynomial(np.array([np.exp(1j * turn), -0.9 * np.exp(3j * turn)]))
        assert switch_of(relay, twice) == pytest.approx(-turn, abs=1e-12)


def test_quiet_phases_lie_in_the_middle_of_what_lasts() -> None:
    given = OddPolynomial(np.array([3.0 + 0j]))
    for gap, flies_longer in ((1.2, False), (4.0, True)):
        loop = ClosedLoop(PLANT, FrictionBacklash(gap))
        flight = flight_of(loop.modes.system.components[0], given, OMEGA)
        flown, contact = (flight.leave + flight.meet) / 2, (flight.meet + flight.leave + PI) / 2
        expected = [flown, contact] if flies_longer else [contact, flown]
        assert _quiet_phases(loop, given, OMEGA) == pytest.approx(expected)
    for element, switch in ((Relay(1.0), PI), (CoulombFriction(1.0), PI / 2)):
        loop = ClosedLoop(control.tf([1.0], [1.0, 2.0, 5.0, 1.0]), element)
        assert _quiet_phases(loop, given, OMEGA) == pytest.approx([switch + PI / 2])
        assert _quiet_phases(loop, OddPolynomial(np.zeros(1, dtype=complex)), OMEGA) == []
    loop = ClosedLoop(PLANT, Relay(1.0, 0.3, 1.7))
    (phase,) = _quiet_phases(loop, given, OMEGA)
    middle = 0.5 * (math.asin(2.0 / 3) + PI - math.asin(1.4 / 3))
    assert math.remainder(phase - middle, 2 * PI) == pytest.approx(0.0, abs=1e-12)
    assert _quiet_phases(loop, OddPolynomial(np.array([1.0 + 0j])), OMEGA) == []
    assert _quiet_phases(ClosedLoop(PLANT, FrictionBacklash(9.0)), given, OMEGA) == []
    assert _quiet_phases(ClosedLoop(PLANT, Saturation(1.0, 1.0)), given, OMEGA) == []


def test_a_balanced_start_adds_up_the_responses_to_all_harmonics() -> None:
    element = ViscousBacklash(1.2, 0.1)
    loop = ClosedLoop(PLANT, element)
    given = OddPolynomial(np.array([3.0, 0.2 - 0.1j, 0.05j]))
    output = steady_response(element, given, OMEGA)
    flight = flight_of(loop.modes.system.components[0], given, OMEGA)
    phase = 0.3 * flight.leave + 0.7 * flight.meet
    start = _start(loop, given, output, OMEGA, phase)
    A, B = loop.model.A, loop.model.B[:, 0]
    responses = [
        np.linalg.inv(1j * n * OMEGA * np.eye(2) - A) @ B * c for n, c in zip((1, 3, 5), output, strict=True)
    ]
    state = sum((x * np.exp(1j * n * phase)).imag for n, x in zip((1, 3, 5), responses, strict=True))
    np.testing.assert_allclose(start.state[:2], state, rtol=1e-12)
    np.testing.assert_allclose(start.sizes[:2], sum(abs(x) for x in responses), rtol=1e-12)
    assert loop.modes.component_modes(start.mode) == (FREE,)
    first = loop.modes.layout.first_states[0]
    # The load has been slowing down since it left.
    since, velocity = (phase - flight.leave) / OMEGA, OMEGA * float(given(flight.leave, 1))
    share = math.exp(-since / 0.1)
    place = float(given(flight.leave)) - 0.6 + 0.1 * velocity * (1 - share)
    assert start.state[first : first + 3] == pytest.approx([place, velocity * share, share], rel=1e-6)
    largest = given.largest()
    assert start.sizes[first : first + 3].tolist() == [largest, OMEGA * largest, 1.0]
    assert (start.state[-1], start.sizes[-1]) == (1.0, 1.0)


def test_balanced_starts_of_a_relay_are_near_its_exact_orbit() -> None:
    """1/(s (s+1) (s+2)) with a relay: half the period solves Tsypkin's equation."""
    plant = control.tf([1.0], [1.0, 3.0, 2.0, 0.0])
    loop = ClosedLoop(plant, Relay(1.0))
    ((start, omega),) = balanced_starts(loop, 4 / PI / 6, math.sqrt(2.0))

    def switching(half: float) -> float:
        return half / 4 - math.tanh(half / 2) + math.tanh(half) / 4

    half = float(scipy.optimize.brentq(switching, 1.0, 4.0))
    assert PI / omega == pytest.approx(half, rel=2e-3)
    flow = scipy.linalg.expm(loop.modes.mode(start.mode).matrix * half / 2)
    at_switch = (flow @ start.state)[: loop.model.nstates]
    assert abs(loop.model.C[0] @ at_switch) < 2e-3 * abs(loop.model.C[0]) @ start.sizes[:3]


def test_rates_are_the_moduli_of_poles_alone_and_in_a_rigid_loop() -> None:
    loop = ClosedLoop(control.ss([[-2.0]], [[3.0]], [[4.0]], [[0.0]]), Relay(1.0))
    assert _rates(loop) == pytest.approx((2.0, 14.0))
    assert quiet_time(loop) == pytest.approx(50 * PI)
    integrator = ClosedLoop(control.ss([[0.0]], [[3.0]], [[4.0]], [[0.0]]), Relay(1.0))
    assert _rates(integrator) == pytest.approx((12.0, 12.0))
    for slow, rates in ((1e-9, (50.0, 50.0)), (1e-7, (1e-7, 50.0))):
        plant = control.ss(np.diag([-slow, -50.0]), [[1.0], [1.0]], [[0.0, 0.0]], [[0.0]])
        assert _rates(ClosedLoop(plant, Relay(1.0))) == pytest.approx(rates)
    still = ClosedLoop(control.ss([[0.0]], [[0.0]], [[4.0]], [[0.0]]), Relay(1.0))
    assert _rates(still) == (1.0, 1.0)


def test_scales_are_gaps_thresholds_and_levels() -> None:
    element = FrictionBacklash(0.8) + (-3.0) * Relay(1.5) + 2.0 * Saturation(0.7, 4.0)
    element = element + (-0.5) * Relay(6.0, 0.3, 1.7) + ViscousFriction(1.0)
    plant = control.tf([1.0], [1.0, 2.0, 5.0, 1.0])
    assert _scales(ClosedLoop(plant, element)) == pytest.approx([0.8, 4.5, 0.7, 3.0, 2.0])
    assert _scales(ClosedLoop(plant, ViscousFriction(1.0))) == [1.0]


def test_initial_states_are_drawn_at_all_sizes_and_the_same_again() -> None:
    loop = ClosedLoop(PLANT, FrictionBacklash(1e-3))
    first, again = (list(initial_states(loop, 40, 3)) for _ in range(2))
    assert len(first) == 40
    for (mode, state), (other, same) in zip(first, again, strict=True):
        assert mode == other
        np.testing.assert_array_equal(state, same)
    inputs = np.array([abs(loop.model.C[0] @ state[:2]) for _, state in first])
    assert inputs.max() < 1e-3 * 10**2 * 10
    assert 1e-6 < np.median(inputs) < 1e-2
    play = [float(loop.modes.mode(mode).signals[0].input @ state) - state[2] for mode, state in first]
    assert max(abs(each) for each in play) <= 0.5e-3 * (1 + 1e-9)
    assert np.ptp(play) > 0.5e-3


def test_the_amplitude_of_half_of_the_initial_states_is_that_of_the_input() -> None:
    # The response is at most 1e-6 per unit: what is meant for the output makes an input below 1e-4.
    small = ClosedLoop(control.tf([1e-6], [1.0, 1.0]), FrictionBacklash(1.0))
    states = [state for _, state in initial_states(small, 60, 5)]
    inputs = np.array([abs(small.model.C[0] @ state[:1]) for state in states])
    assert 15 < (inputs > 2e-4).sum() < 45
    assert inputs.max() < 1e2
    # Where no input answers, the output alone can have an amplitude.
    unseen = ClosedLoop(control.ss([[-1.0]], [[2.0]], [[0.0]], [[0.0]]), FrictionBacklash(1.0))
    drawn = np.array([state[0] for _, state in initial_states(unseen, 20, 5)])
    assert np.isfinite(drawn).all()
    assert 1e-3 < abs(drawn).max() < 2e2


class AlwaysTheSame:
    """A generator that draws the same share of each range."""

    def __init__(self, share: float) -> None:
        self.share = share

    def uniform(self, low: float, high: float, count: int | None = None) -> float | np.ndarray:
        value = low + self.share * (high - low)
        return value if count is None else np.full(count, value)

    def integers(self, count: int) -> int:
        return count - 1

    def random(self) -> float:
        return self.share


@pytest.mark.parametrize("share", [0.3, 0.8])
def test_initial_states_are_responses_to_what_was_drawn(monkeypatch, share: float) -> None:
    gap = 4e-5
    loop = ClosedLoop(PLANT, FrictionBacklash(gap))
    monkeypatch.setattr(np.random, "default_rng", lambda seed: AlwaysTheSame(share))
    (mode, in_box), (_, in_swing), *others = initial_states(loop, 4, 3)
    np.testing.assert_array_equal([state for _, state in others], [in_box, in_swing])
    A, B, C = (np.asarray(each) for each in (loop.model.A, loop.model.B, loop.model.C))
    moduli = abs(np.concatenate([np.linalg.eigvals(A), np.linalg.eigvals(A - B @ C)]))
    omega = (moduli.min() / 3) ** (1 - share) * (3 * moduli.max()) ** share
    size = gap * 10 ** (3 * share - 1)
    response = (np.linalg.inv((0.01 + 1j) * omega * np.eye(2) - A) @ B)[:, 0]
    # Below a half the size is that of the input, else that of the output.
    response *= size / abs(C[0] @ response) if share < 0.5 else size
    np.testing.assert_allclose(in_box[:2], abs(response) * (2 * share - 1), rtol=1e-9)
    np.testing.assert_allclose(in_swing[:2], (response * np.exp(2j * math.pi * share)).real, rtol=1e-9)
    apart = float(loop.modes.mode(mode).signals[0].input @ in_box) - in_box[2]
    assert abs(apart) == pytest.approx(abs(share - 0.5) * gap, rel=1e-6)
