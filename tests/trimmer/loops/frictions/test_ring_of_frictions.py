"""Frictions in a ring: how they share the force is open, the motion is not, and it never chatters."""

import itertools
import math

import numpy as np
import pytest

from tests.quick import quick
from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Motion, energy_balance, simulate
from trimmer.elements import Element
from trimmer.loops import BodyFriction, Drive, EventKind, Outcome, TrimmerLoop
from trimmer.thesis import Displacement, InputChannels, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
AMPLITUDE, OMEGA = 1.5e-3, 2 * math.pi * 110
DRIVE = Drive(AMPLITUDE, OMEGA)
Ring = tuple[tuple[Displacement, float], ...]
NODES = (None, *TrimmerBody)
BETWEEN_BODIES: Ring = (
    (Displacement(TrimmerBody.CUTTER, TrimmerBody.MOTOR), 3.5),
    (Displacement(TrimmerBody.GUARD, TrimmerBody.MOTOR), 0.12),
    (Displacement(TrimmerBody.GUARD, TrimmerBody.CUTTER), 0.014),
)
WITH_GROUND: Ring = (
    (Displacement(TrimmerBody.CUTTER), 0.1),
    (Displacement(TrimmerBody.GUARD), 0.15),
    (Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), 18.0),
)
EXAMPLES = {"between bodies": BETWEEN_BODIES, "with ground": WITH_GROUND}


def between(first: TrimmerBody | None, second: TrimmerBody | None) -> Displacement:
    return (
        Displacement(second, None)
        if first is None and second
        else Displacement(first or TrimmerBody.MOTOR, second)
    )


def some_frictions(seed: int, fewest: int = 3, most: int = 3) -> Ring:
    """Three frictions in a ring, or as many as asked for anywhere, of 0.01 to 100 N."""
    random = np.random.default_rng(seed)
    pairs = list(itertools.combinations(range(5), 2))
    count = int(random.integers(fewest, most + 1))
    if most == 3:
        pairs = list(itertools.combinations(sorted(random.choice(5, 3, replace=False)), 2))
    chosen = random.choice(len(pairs), count, replace=False)
    return tuple(
        (between(NODES[pairs[each][0]], NODES[pairs[each][1]]), float(10 ** random.uniform(-2.0, 2.0)))
        for each in chosen
    )


def loop_of(ring: Ring, element: Element | None = None, drive: Drive | None = DRIVE) -> TrimmerLoop:
    frictions = tuple(BodyFriction(each, CoulombFriction(force)) for each, force in ring)
    return TrimmerLoop(THESIS, element, drive, channels=InputChannels.DISPLACEMENT_ONLY, frictions=frictions)


def matrices() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the masses, C and K of the trimmer, from its springs and dampers."""
    p = THESIS
    ends = ((1, 0, 0, 0), (1, -1, 0, 0), (0, 0, 1, 0), (0, 0, 1, -1), (0, 1, -1, 0))
    dampers, springs = (p.c1, p.c2, p.c3, p.c4, 0.0), (p.k1, p.k2, p.k3, p.k4, p.k5)
    C, K = (sum(x * np.outer(row, row) for row, x in zip(ends, of, strict=True)) for of in (dampers, springs))
    return np.array([p.m1, p.m2, p.m3, p.m4]), C, K


def check_laws(ring: Ring, duration: float) -> Motion:
    """Check Newton's and Coulomb's laws along a motion, which have one solution, and the energy.

    Newton's as the change of momentum over each piece between events, by quadrature of all forces.
    """
    motion = simulate(loop_of(ring), duration)
    assert motion.outcome is Outcome.COMPLETED
    ends = np.unique([*np.linspace(0.0, duration, 1 + int(duration / 2e-4)), *motion.event_times])
    nodes, weights = np.polynomial.legendre.leggauss(10)
    times = 0.5 * (ends[:-1, None] + ends[1:, None] + np.diff(ends)[:, None] * nodes)
    states, forces = motion.state(times), motion.component_outputs(times)[1:]
    rows, limits = np.array([each.row for each, _ in ring]), np.array([force for _, force in ring])
    masses, C, K = matrices()
    push = np.multiply.outer([-1.0, 1.0, 0.0, 0.0], THESIS.k2 * AMPLITUDE * np.sin(OMEGA * times))
    terms = [push, -np.tensordot(K, states[:4], 1), -np.tensordot(C, states[4:], 1)]
    terms.append(-np.tensordot(rows.T, forces, 1))
    impulses = 0.5 * np.diff(ends) * (sum(terms) @ weights)
    gained = masses[:, None] * np.diff(motion.state(ends)[4:])
    largest = max(abs(term).max() for term in terms) * np.diff(ends).max()
    assert abs(impulses - gained).max() < 1e-9 * largest
    sliding = np.tensordot(rows, states[4:], 1)
    slides = abs(sliding) > 1e-9 * AMPLITUDE * OMEGA
    assert (abs(forces) <= limits[:, None, None] * (1 + 1e-12)).all()
    assert (forces == np.sign(sliding) * limits[:, None, None])[slides].all()
    assert energy_balance(motion).residual < 1e-10
    return motion


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_examples_go_on_to_the_end(name: str) -> None:
    motion = check_laws(EXAMPLES[name], 0.2)
    kinds = {event.kind for event in motion.events}
    assert {EventKind.STICK, EventKind.SLIP} <= kinds
    together = [time for time, events in itertools.groupby(motion.events, key=lambda each: each.time)]
    assert len(together) < len(motion.events)  # Two of a ring stick and slip at one instant.


@pytest.mark.parametrize("phase", [1.5, -2.0])
def test_what_a_friction_does_at_an_instant_is_one_event(phase: float) -> None:
    """Pushed from rest three slip at once; then one of them sticks, so that it has done nothing."""
    motion = simulate(loop_of(some_frictions(8, 3, 4), drive=Drive(AMPLITUDE, OMEGA, phase)), 0.02)
    changes = [(each.time, each.component) for each in motion.events]
    assert len(set(changes)) == len(changes)
    assert {each.component for each in motion.events if each.time == 0} == {"friction q2", "friction q2-q4"}


def test_three_frictions_in_a_ring() -> None:
    check_laws(some_frictions(1), 0.1)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(0, 180, 3))
def test_many_frictions_in_rings(seed: int) -> None:
    check_laws(some_frictions(seed), 0.2)
    check_laws(some_frictions(seed, 4, 6), 0.1)


def test_frictions_that_repeat_each_other_are_one_with_the_sum_of_the_forces() -> None:
    blades = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)
    ground = (Displacement(TrimmerBody.GUARD), 0.3)
    one = simulate(loop_of(((blades, 2.0), ground)), 0.1)
    three = simulate(loop_of(((blades, 0.2), (blades, 1.7), ground, (blades, 0.1))), 0.1)
    times = np.linspace(0.0, 0.1, 200)
    assert three.state(times) == pytest.approx(one.state(times), rel=1e-9, abs=1e-13)
    forces = three.component_outputs(times)
    assert forces[[1, 2, 4]].sum(axis=0) == pytest.approx(one.component_outputs(times)[1], rel=1e-9, abs=1e-9)
    assert (abs(forces[[1, 2, 4]]).max(axis=1) <= [0.2, 1.7, 0.1]).all()


@pytest.mark.parametrize("gap", quick([None, 2e-4], 1))
def test_a_force_just_at_its_limit_is_no_event_for_ever(gap: float | None) -> None:
    """The cutter slides and pulls the guard with 1 N; the motor holds it with at most 1 N."""
    ring = (
        (Displacement(TrimmerBody.MOTOR, TrimmerBody.GUARD), 1.0),
        (Displacement(TrimmerBody.CUTTER), 1.0),
        (Displacement(TrimmerBody.MOTOR), 5.0),
        (Displacement(TrimmerBody.HOUSING, TrimmerBody.GUARD), 1.0),
        (Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), 1.0),
    )
    motion = simulate(loop_of(ring, None if gap is None else FrictionBacklash(gap)), 0.1)
    assert motion.outcome is Outcome.COMPLETED
    assert energy_balance(motion).residual < 1e-10


def test_a_load_comes_to_rest_at_a_pin_that_friction_holds() -> None:
    ring = (
        (Displacement(TrimmerBody.CUTTER), 1.0),
        (Displacement(TrimmerBody.MOTOR, TrimmerBody.GUARD), 6.0),
        (Displacement(TrimmerBody.MOTOR, TrimmerBody.CUTTER), 16.0),
        (Displacement(TrimmerBody.MOTOR), 16.0),
        (Displacement(TrimmerBody.HOUSING), 1.0),
    )
    motion = simulate(loop_of(ring, InertiaBacklash(2e-4), None), 0.1, impulse=1e-3)
    assert motion.outcome is Outcome.COMPLETED
    assert energy_balance(motion).residual < 1e-10
