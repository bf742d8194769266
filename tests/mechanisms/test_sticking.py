"""Forces of frictions that stick together: linear programming and its dual say the same, and a ring holds."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.linalg import null_space

from tests.mechanisms.brute_force import BruteForce, EventKind
from tests.mechanisms.sticking import load, smallest_supports, stick_together
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction


@pytest.mark.parametrize("seed", range(20))
def test_the_dual_gives_the_load_that_linear_programming_gives(seed):
    random = np.random.default_rng(seed)
    ends = random.permutation(list(itertools.combinations(range(-1, 3), 2)))[: random.integers(3, 7)]
    directions = np.zeros((len(ends), 3))
    for row, (start, end) in enumerate(ends):
        directions[row, end] += 1
        if start >= 0:
            directions[row, start] -= 1
    masses, force = random.uniform(0.1, 10, 3), random.normal(size=(3, 1))
    sticking = stick_together(directions, np.diag(masses), force, np.zeros((len(ends), 1)))
    limits = random.uniform(0.1, 2, len(ends))
    forces = sticking.forces[:, 0]
    by_dual = max(abs(w @ forces) / (np.abs(w) @ limits) for w in smallest_supports(sticking.null))
    np.testing.assert_allclose(directions.T @ sticking.null, 0, atol=1e-12)
    assert sticking.null.shape[1] == null_space(directions.T).shape[1]
    assert by_dual == pytest.approx(load(forces, sticking.null, limits), rel=1e-9)


def ring(static: float | None) -> Mechanism:
    """Three frictions of 1 N in a ring of two bodies and the ground; the force on one body grows."""
    ends = {"a on ground": ("ground", "a"), "b on ground": ("ground", "b"), "a on b": ("a", "b")}
    return Mechanism(
        bodies={"a": Body(1.0), "b": Body(2.0)},
        frequency=1.0,
        frictions={name: Friction(between, 1.0, static) for name, between in ends.items()},
        forces={"pull": Force("a", constant=1.25, amplitude=1.25)},
    )


def test_a_ring_holds_as_long_as_some_split_is_admissible():
    motion = BruteForce().from_rest(ring(None), 0.2)
    released = np.arcsin(0.75 / 1.25) / (2 * np.pi)
    first = motion.events[0]
    assert first.time == pytest.approx(released, abs=1e-12)
    moving = {event.part for event in motion.events if abs(event.time - released) < 1e-9}
    assert moving == {"a on ground", "a on b"}
    assert motion.final[3] == 0
    assert all(event.kind is EventKind.STICK_ENDED for event in motion.events)


def test_static_friction_holds_the_ring_for_longer():
    motion = BruteForce().from_rest(ring(1.2), 0.5)
    assert motion.events[0].time == pytest.approx(np.arcsin(1.15 / 1.25) / (2 * np.pi), abs=1e-12)
    assert {event.part for event in motion.events[:2]} == {"a on ground", "a on b"}
