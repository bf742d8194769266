"""The brute force against what follows on paper, before anything is held against it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from tests.mechanisms import cases, closed_forms
from tests.mechanisms.brute_force import BruteForce, EventKind, start_state
from tests.mechanisms.dynamics import System
from tests.mechanisms.measures import extremes, harmonics, root_mean_square, settled
from tests.mechanisms.oscillator_events import Oscillator, with_friction, with_stop
from tests.quick import quick
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Stop

# Displacements, velocities and z of the settled trimmer at t = 0, by this integrator at 1e-13.
SETTLED = {
    ContactLaw.RELAXING: [
        *(2.0655693515102308e-05, 7.510248101288356e-05, 1.3026257939538976e-05, 3.157106157114776e-05),
        *(0.047107612498702336, 1.1404402302586487, 0.009332797311264707, 0.013011400948495759),
        -3.444678749778163e-05,
    ],
    ContactLaw.TRUNCATED: [
        *(2.0655693526213666e-05, 7.510248105425093e-05, 1.3026257939343362e-05, 3.157106157037943e-05),
        *(0.04710761247559767, 1.140440230433436, 0.009332797313155094, 0.013011400953949466),
    ],
    ContactLaw.PULLING: [
        *(2.064380286376907e-05, 7.505155244247063e-05, 1.3026149796941002e-05, 3.1571374014665674e-05),
        *(0.04718192059483772, 1.1405966937119958, 0.009331550701576815, 0.01300887977760854),
    ],
}
STROKES = {
    ContactLaw.RELAXING: (2.933334121400e-3, 1e-15),
    ContactLaw.TRUNCATED: (2.933334121515e-3, 1e-15),
    ContactLaw.PULLING: (2.93306e-3, 5e-9),
}


def times_of(motion, kind: EventKind) -> list[float]:
    return [event.time for event in motion.events if event.kind is kind]


@pytest.mark.parametrize("law", quick(ContactLaw, 0))
def test_event_times_of_a_stop(law):
    stop = Stop(("ground", "body"), 50.0, 2.0, 0.25, law)
    motion = BruteForce().from_rest(cases.driven_oscillator({"wall": stop}, {}), 7.0)
    with mp.workdps(30):
        oscillator = Oscillator(1.0, 0.25, 4.0, 3.0, mpf(3.0))
        exact = with_stop(oscillator, (50.0, 2.0, 0.25), law, (0, 0), mpf(7))
    made, broken = (times_of(motion, kind) for kind in (EventKind.CONTACT_MADE, EventKind.CONTACT_BROKEN))
    np.testing.assert_allclose(made, np.array(exact.made, dtype=float), rtol=0, atol=2e-12)
    np.testing.assert_allclose(broken, np.array(exact.broken, dtype=float), rtol=0, atol=2e-12)
    wanted = [float(exact.displacement), float(exact.velocity)]
    np.testing.assert_allclose(motion.final[:2], wanted, rtol=0, atol=5e-12)


def test_event_times_of_friction_with_stick():
    rub = Friction(("ground", "body"), 1.0, 1.25)
    mechanism = cases.driven_oscillator({}, {"rub": rub}, omega=0.75, amplitude=2.0, velocity=0.5)
    motion = BruteForce().from_rest(mechanism, 12.0)
    with mp.workdps(30):
        oscillator = Oscillator(1.0, 0.25, 4.0, 2.0, mpf(0.75))
        exact = with_friction(oscillator, 1.0, 1.25, (0, 0.5), mpf(12))
    begun, ended = (times_of(motion, kind) for kind in (EventKind.STICK_BEGUN, EventKind.STICK_ENDED))
    np.testing.assert_allclose(begun, np.array(exact.begun, dtype=float), rtol=0, atol=2e-12)
    np.testing.assert_allclose(ended, np.array(exact.ended, dtype=float), rtol=0, atol=2e-12)
    wanted = [float(exact.displacement), float(exact.velocity)]
    np.testing.assert_allclose(motion.final, wanted, rtol=0, atol=5e-12)


def test_block_on_a_belt():
    exact = closed_forms.block_on_belt(1, 1, 1, 0.5, 0.2)
    motion = BruteForce().from_rest(cases.block_on_belt((1.0, 0.2)), 20.0)
    begun, ended = (times_of(motion, kind) for kind in (EventKind.STICK_BEGUN, EventKind.STICK_ENDED))
    assert ended == pytest.approx([float(exact.period), 2 * float(exact.period)], abs=1e-11)
    assert begun[:2] == pytest.approx([float(exact.slip), float(exact.period + exact.slip)], abs=1e-11)
    low, high = extremes(motion, lambda _: motion.system.rows.displacement("block"))
    assert low == pytest.approx(0.5 - float(exact.amplitude), abs=1e-11)
    assert high == pytest.approx(0.5 + float(exact.amplitude), abs=1e-11)


@pytest.mark.parametrize("law", [ContactLaw.TRUNCATED, ContactLaw.RELAXING])
@pytest.mark.parametrize("damping_ratio", [0.1, 0.3, 0.6])
def test_rebound(damping_ratio, law):
    motion = BruteForce().from_rest(cases.thrown(damping_ratio, law), 6.0)
    assert [event.kind for event in motion.events] == [EventKind.CONTACT_MADE, EventKind.CONTACT_BROKEN]
    assert -motion.final[1] == pytest.approx(float(closed_forms.rebound_ratio(damping_ratio)), abs=1e-12)


def test_flight_under_a_constant_force():
    mechanism = Mechanism(
        bodies={"body": Body(0.3)}, forces={"weight": Force("body", 2.0)}, start={"body": (0.1, -3.0)}
    )
    motion = BruteForce().from_rest(mechanism, 0.7)
    assert motion.final[0] == pytest.approx(float(closed_forms.flight(0.1, -3.0, 2.0, 0.3, 0.7)), rel=1e-13)


def test_a_linear_chain_stays_in_its_steady_state():
    omega = 2.0
    x = closed_forms.steady_state([1, 2], [[0.3, -0.2], [-0.2, 0.2]], [[3, -2], [-2, 2]], [0, 1.5], omega)
    start = {
        name: (float(x[place].imag), float((1j * omega * x[place]).imag)) for place, name in enumerate("ab")
    }
    mechanism = Mechanism(
        bodies={"a": Body(1.0), "b": Body(2.0)},
        frequency=omega / (2 * math.pi),
        links={"mount": Link(("ground", "a"), 1.0, 0.1), "coupling": Link(("a", "b"), 2.0, 0.2)},
        forces={"drive": Force("b", amplitude=1.5)},
        start=start,
    )
    motion = BruteForce().from_rest(mechanism, 3 * 2 * math.pi / omega)
    np.testing.assert_allclose(motion.final, np.array(list(start.values())).T.ravel(), rtol=0, atol=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize(("ratio", "force"), [(0.7, 0.2), (1.2, 0.5), (2.0, 0.3)])
def test_den_hartog(ratio, force):
    system = System(cases.den_hartog(ratio, force))
    end = settled(BruteForce(), system, start_state(system), 400, 1e-13)
    low, high = extremes(end.motion, lambda _: system.rows.displacement("body"))
    exact = float(closed_forms.den_hartog_amplitude(ratio, force))
    assert (high - low) / 2 == pytest.approx(exact, rel=1e-10)
    assert [event.kind for event in end.motion.events] == [EventKind.SLIDING_REVERSED] * 2


@pytest.mark.parametrize("law", quick(ContactLaw, 0))
def test_the_settled_trimmer_has_the_digits_of_the_definition(law):
    system = System(cases.trimmer(law))
    end = settled(BruteForce(), system, np.array(SETTLED[law]), 1, 0.0)
    assert end.change < 1e-11
    holds_first_case(end.motion, law)


@pytest.mark.slow
@pytest.mark.parametrize("law", list(ContactLaw))
def test_the_trimmer_settles_from_rest_to_the_digits_of_the_definition(law):
    system = System(cases.trimmer(law))
    end = settled(BruteForce(), system, start_state(system), 120, 1e-13)
    holds_first_case(end.motion, law)
    np.testing.assert_allclose(end.motion.final, SETTLED[law], rtol=1e-9)


def holds_first_case(motion, law):
    rows = motion.system.rows
    stroke = rows.displacement("cutter") - rows.displacement("guard")
    low, high = extremes(motion, lambda _: stroke)
    printed, last_digit = STROKES[law]
    assert len(motion.events) == 14
    assert high - low == pytest.approx(printed, abs=last_digit)
    lines = harmonics(motion, stroke, [1, 2, 3, 4, 5])
    assert np.all(lines[[1, 3]] < 1e-13)
    if law is ContactLaw.RELAXING:
        odd = [1.50471470358e-3, 1.14721349311e-4, 3.3929164589e-5]
        assert lines[[0, 2, 4]] == pytest.approx(odd, rel=1e-10, abs=0)
        motor = root_mean_square(motion, lambda mode: motion.system.dynamics(mode).rates[4])
        assert motor == pytest.approx(118.754895, abs=5e-7)
