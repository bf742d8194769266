"""What a linear system with several elements cannot be, and what is said then."""

from collections.abc import Callable
from typing import Any

import control
import numpy as np
import pytest

import trimmer
from trimmer import ClosedLoop, CoulombFriction, DeadZone, Drive, Feedback, periodic_orbits, simulate
from trimmer.errors import IllPosedLoopError, LoopError


def plant(**changes: Any) -> control.StateSpace:
    """x'' = -u, with velocity and displacement, all of it changed at will."""
    given = {"A": [[0, 1], [0, 0]], "B": [[0, 0], [-1, -1]], "C": [[0, 1], [1, 0]], "D": [[0, 0], [0, 0]]}
    names = {"states": ["x", "v"], "inputs": ["rub", "spring"], "outputs": ["rub", "spring"]}
    all_of_it = {**given, **names, **changes}
    matrices = [all_of_it.pop(name) for name in "ABCD"]
    return control.ss(*matrices, **all_of_it)


RUB, SPRING = CoulombFriction(1.0), DeadZone(0.1)
ONE, BOTH = {"rub": RUB}, {"rub": RUB, "spring": SPRING}
PUSH = Drive(1.0, frequency=1.0)


@pytest.mark.parametrize(
    ("given", "kind", "message"),
    [
        ((3, ONE), TypeError, "give a control.StateSpace or"),
        ((plant(dt=0.1), ONE), TypeError, "continuous in time, not sampled"),
        ((plant(), {}), LoopError, "elements: give at least one"),
        ((plant(), [RUB]), TypeError, "elements must be a mapping of names"),
        ((plant(), {"rub": 2.0}), TypeError, r"elements\['rub'\] must be an element"),
        (
            (plant(outputs=["v", "spring"]), ONE),
            LoopError,
            r"the element 'rub' has no partner: the plant has no output 'rub'; there are v and spring. Name",
        ),
        ((plant(inputs=["rub", "springs"]), BOTH), LoopError, "no input 'spring'; did you mean springs"),
        ((control.ss(0.0, -1.0, 1.0, 0.0), {"v": RUB}), LoopError, r"there is y\[0\]"),
        ((plant(), ONE, {"spring": 1.0}), TypeError, "must be a trimmer.Drive"),
        (
            (plant(), ONE, {"force": PUSH}),
            LoopError,
            "the drive 'force' has no partner: the plant has no input 'force'; there are rub and spring",
        ),
        ((plant(), ONE, {"rub": PUSH}), LoopError, "'rub' has an element, so that no drive can set it too"),
        (
            (plant(D=[[0, 0], [0, 0.5]]), BOTH),
            IllPosedLoopError,
            r"the element 'spring' acts on itself without delay: D of the plant .*0\.5.* put what lies",
        ),
        (
            (plant(D=[[0, 0], [2, 0]]), BOTH),
            IllPosedLoopError,
            "the element 'rub' acts on the element 'spring' without delay",
        ),
        (
            (plant(), {"spring": RUB}),
            IllPosedLoopError,
            "spring: the friction acts not at once on what the output of its name gives .C B is 0",
        ),
        (
            (plant(B=[[0, 0], [1, 1]]), ONE),
            IllPosedLoopError,
            "rub: the friction drives what .* let B carry the minus of its force",
        ),
        ((plant(), {"spring": trimmer.StaticElement(np.tanh)}), TypeError, "has no description in time"),
    ],
)
def test_what_cannot_be_is_refused_with_what_to_do(given: tuple, kind: type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        Feedback(*given)


@pytest.mark.parametrize(
    ("ask", "kind", "message"),
    [
        (
            lambda loop: simulate(loop, 1.0, impulse=1.0),
            TypeError,
            "impulse is no argument beside a state, or",
        ),
        (lambda loop: simulate(loop, 1.0, state=[1.0, 2.0, 3.0]), LoopError, r"\(3,\), .* 2 states: x and v"),
        (
            lambda _: ClosedLoop(control.tf([1], [1, 1]), [RUB, SPRING]),
            TypeError,
            r"several elements go into trimmer\.Feedback\(plant, \{name: element\}\)",
        ),
        (lambda _: Feedback(plant(), ONE, start={"y": 1.0}), LoopError, "no state of the loop"),
        (lambda _: RUB * SPRING, TypeError, r"a product of elements .* trimmer\.Feedback\(plant"),
        (
            lambda _: periodic_orbits(Feedback(plant(), ONE, {"spring": PUSH})),
            TypeError,
            "forced_orbit finds its periodic motion",
        ),
        (
            lambda _: periodic_orbits(Feedback(plant(), BOTH), [(1.0, 2.0)]),
            TypeError,
            "forced_orbit takes a state as guess",
        ),
        (
            lambda _: trimmer.limit_cycles(Feedback(plant(), BOTH)),
            TypeError,
            "several elements or frictions; harmonic_balance, periodic_orbits and respond find its motions",
        ),
    ],
)
def test_what_it_is_not_asked_for_is_refused_with_what_to_do(
    ask: Callable[[Feedback], object], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        ask(Feedback(plant(), ONE))
