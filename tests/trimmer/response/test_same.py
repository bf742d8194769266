"""When two orbits of a mechanism are one, or mirrored twins."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from trimmer.mechanism import Body, Force, Friction, Link, Mechanism, Pin, Play, Stop
from trimmer.response.same import (
    is_mirror_symmetric,
    keeps_symmetry,
    same_states,
)

SYMMETRIC = Mechanism(
    {"body": Body(1.0)},
    frequency=2.0,
    pins={"pin": Pin("ground", amplitude=1.0, order=3)},
    plays={"slot": Play(("pin", "body"), 10.0, 0.0, 0.2)},
    frictions={"floor": Friction(("ground", "body"), 0.1)},
    links={"spring": Link(("ground", "body"), 4.0)},
    forces={"push": Force("body", amplitude=1.0)},
)
SIZES = np.array([2.0, 50.0])


def test_what_acts_on_one_side_only_breaks_the_symmetry() -> None:
    assert is_mirror_symmetric(SYMMETRIC)
    pin, force = SYMMETRIC.pins["pin"], SYMMETRIC.forces["push"]
    for changes in (
        {"frequency": None},
        {"pins": {"pin": replace(pin, order=2)}},
        {"pins": {"pin": replace(pin, offset=0.1)}},
        {"pins": {"pin": replace(pin, velocity=0.1)}},
        {"forces": {"push": replace(force, constant=0.1)}},
        {"forces": {"push": replace(force, order=2)}},
        {"stops": {"wall": Stop(("ground", "body"), 10.0, 0.0, 0.2)}},
    ):
        assert not is_mirror_symmetric(replace_or_rest(changes))


def replace_or_rest(changes: dict) -> Mechanism:
    """Change a mechanism; without a drive nothing moves by amplitude."""
    if "frequency" in changes:
        return Mechanism({"body": Body(1.0)}, links={"spring": Link(("ground", "body"), 4.0)})
    return replace(SYMMETRIC, **changes)


def test_states_agree_wherever_the_period_begins() -> None:
    ours = np.array([[1.0, 20.0], [2.0, -30.0], [-1.0, 40.0]])
    allowed = np.array([0.01, 0.5])
    for turns in range(3):
        theirs = np.roll(ours, turns, axis=0)
        assert same_states(ours, theirs, allowed)
        assert same_states(ours, theirs + 0.9 * allowed, allowed)
        assert not same_states(ours, theirs + np.array([0.0, 0.6]), allowed)
        assert not same_states(ours, theirs - np.array([0.02, 0.0]), allowed)
    assert not same_states(ours, ours[::-1], allowed)
    assert not same_states(ours, ours[:1], allowed)


def orbit(strobed: list, halfway: list, periods: int = 0, mechanism: Mechanism = SYMMETRIC):
    """An orbit with given states at the start and in the middle of each drive period of 0.5 s."""
    times = 0.5 * (0.5 + np.arange(len(halfway)))

    def states(asked: np.ndarray) -> np.ndarray:
        np.testing.assert_allclose(asked, times)
        return np.column_stack([halfway, np.ones(len(halfway))])

    return SimpleNamespace(
        mechanism=mechanism,
        periods=periods or len(strobed),
        strobed=np.array(strobed),
        sizes=SIZES,
        course=SimpleNamespace(states=states),
        flow=SimpleNamespace(period=0.5, size=2, reduced=lambda states: states),
    )


def test_whether_an_orbit_keeps_the_symmetry() -> None:
    assert keeps_symmetry(orbit([[1.0, 20.0]], [[-1.0, -20.0]])) is True
    assert keeps_symmetry(orbit([[1.0, 20.0]], [[-1.0, -19.0]])) is False
    for shift, kept in (
        ([0.0, 4e-5], True),
        ([0.0, 6e-5], False),
        ([1.9e-6, 0.0], True),
        ([2.1e-6, 0.0], False),
    ):
        found = orbit([[1.0, 20.0]], [[-1.0 + shift[0], -20.0 - shift[1]]])
        assert keeps_symmetry(found) is kept
    alone = orbit([[1.0, 20.0]], [[-1.0, -20.0]])
    alone.periods = 0
    assert keeps_symmetry(alone) is None
