"""The smooth model tends to the sharp one as its smallness does: neither knows the other's laws of events."""

from __future__ import annotations

import numpy as np
import pytest

from tests.mechanisms import cases
from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.regularised import Regularised
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Stop

PERIOD = 1 / 110


def errors(mechanism: Mechanism, duration: float, smallness: list[float]) -> list[float]:
    """Largest error of the final state, relative to usual sizes."""
    sharp = BruteForce(1e-11).from_rest(mechanism, duration)
    usual = sharp.system.usual[: len(sharp.final)]
    return [
        float(np.max(np.abs(Regularised(small).final(mechanism, duration) - sharp.final) / usual))
        for small in smallness
    ]


@pytest.mark.slow
@pytest.mark.parametrize("law", list(ContactLaw))
def test_the_trimmer(law):
    coarse, finer, finest = errors(cases.trimmer(law), PERIOD, [1e-3, 1e-4, 1e-5])
    assert finer < coarse / 3
    assert finest < finer / 3
    assert finest < 2e-4


@pytest.mark.slow
def test_stick_slip_of_two_bodies_in_a_ring():
    mechanism = ring_of_three()
    coarse, finer, finest = errors(mechanism, 2.0, [1e-3, 1e-4, 1e-5])
    assert finer < coarse / 3
    assert finest < finer / 3
    assert finest < 2e-4


@pytest.mark.slow
def test_one_stop_and_one_friction():
    stop = Stop(("ground", "body"), 50.0, 2.0, 0.25)
    mechanism = cases.driven_oscillator({"wall": stop}, {"rub": Friction(("ground", "body"), 0.4)})
    coarse, finer = errors(mechanism, 3.0, [1e-3, 1e-4])
    assert finer < coarse / 5
    assert finer < 1e-3


def ring_of_three() -> Mechanism:
    """Two bodies that rub on each other and on the ground."""
    return Mechanism(
        bodies={"a": Body(1.0), "b": Body(0.5)},
        frequency=1.0,
        links={"held": Link(("ground", "a"), 20.0, 0.2), "coupled": Link(("a", "b"), 15.0, 0.1)},
        frictions={
            "a on ground": Friction(("ground", "a"), 1.0),
            "b on ground": Friction(("ground", "b"), 0.6),
            "a on b": Friction(("a", "b"), 0.5),
        },
        forces={
            "on a": Force("a", amplitude=3.0, phase=0.3),
            "on b": Force("b", amplitude=2.0, phase=1.3, order=2),
        },
    )
