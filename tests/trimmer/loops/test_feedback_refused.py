"""What a linear system with several elements cannot be, and what is said then."""

from collections.abc import Callable, Mapping
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
BOTH = {"rub": RUB, "spring": SPRING}
REFUSED: Mapping[str, tuple[Callable[[], object], type[Exception], str]] = {
    "no plant": (lambda: Feedback(3, {"rub": RUB}), TypeError, "give a control.StateSpace or"),
    "sampled": (lambda: Feedback(plant(dt=0.1), {"rub": RUB}), TypeError, "continuous in time, not sampled"),
    "no elements": (lambda: Feedback(plant(), {}), LoopError, "elements: give at least one"),
    "a list": (lambda: Feedback(plant(), [RUB]), TypeError, "elements must be a mapping of names"),
    "no element": (
        lambda: Feedback(plant(), {"rub": 2.0}),
        TypeError,
        r"elements\['rub'\] must be an element",
    ),
    "no output": (
        lambda: Feedback(plant(outputs=["v", "spring"]), {"rub": RUB}),
        LoopError,
        r"the element 'rub' has no partner: the plant has no output 'rub'; there are v and spring. Name",
    ),
    "no input": (
        lambda: Feedback(plant(inputs=["rub", "springs"]), BOTH),
        LoopError,
        "the plant has no input 'spring'; did you mean springs",
    ),
    "names by default": (
        lambda: Feedback(control.ss(0.0, -1.0, 1.0, 0.0), {"v": RUB}),
        LoopError,
        r"there is y\[0\]",
    ),
    "no drive": (
        lambda: Feedback(plant(), {"rub": RUB}, {"spring": 1.0}),
        TypeError,
        "must be a trimmer.Drive",
    ),
    "nothing to drive": (
        lambda: Feedback(plant(), {"rub": RUB}, {"force": Drive(1.0, frequency=1.0)}),
        LoopError,
        "the drive 'force' has no partner: the plant has no input 'force'; there are rub and spring",
    ),
    "driven twice": (
        lambda: Feedback(plant(), {"rub": RUB}, {"rub": Drive(1.0, frequency=1.0)}),
        LoopError,
        "the input 'rub' has an element, so that no drive can set it too",
    ),
    "on itself": (
        lambda: Feedback(plant(D=[[0, 0], [0, 0.5]]), BOTH),
        IllPosedLoopError,
        r"the element 'spring' acts on itself without delay: D of the plant .*0\.5.* put what lies",
    ),
    "on another": (
        lambda: Feedback(plant(D=[[0, 0], [2, 0]]), BOTH),
        IllPosedLoopError,
        "the element 'rub' acts on the element 'spring' without delay",
    ),
    "a displacement": (
        lambda: Feedback(plant(), {"spring": RUB}),
        IllPosedLoopError,
        "spring: the friction acts not at once on what the output of its name gives .C B is 0",
    ),
    "a driving friction": (
        lambda: Feedback(plant(B=[[0, 0], [1, 1]]), {"rub": RUB}),
        IllPosedLoopError,
        "rub: the friction drives what .* let B carry the minus of its force",
    ),
    "no motion": (
        lambda: Feedback(plant(), {"spring": trimmer.StaticElement(np.tanh)}),
        TypeError,
        "has no description in time",
    ),
    "no state": (
        lambda: Feedback(plant(), {"rub": RUB}, start={"y": 1.0}),
        LoopError,
        "no state of the loop",
    ),
    "other starts": (
        lambda: simulate(Feedback(plant(), {"rub": RUB}), 1.0, impulse=1.0),
        TypeError,
        "impulse is no argument beside a state, or of a Feedback",
    ),
    "a wrong number": (
        lambda: simulate(Feedback(plant(), {"rub": RUB}), 1.0, state=[1.0, 2.0, 3.0]),
        LoopError,
        r"shape \(3,\), but the loop has 2 states: x and v",
    ),
    "several in one": (
        lambda: ClosedLoop(control.tf([1], [1, 1]), [RUB, SPRING]),
        TypeError,
        r"several elements go into trimmer\.Feedback\(plant, \{name: element\}\)",
    ),
    "a product": (lambda: RUB * SPRING, TypeError, r"a product of elements .* trimmer\.Feedback\(plant"),
    "a drive": (
        lambda: periodic_orbits(Feedback(plant(), {"rub": RUB}, {"spring": Drive(1.0, frequency=1.0)})),
        TypeError,
        "forced_orbit finds its periodic motion",
    ),
    "guesses": (
        lambda: periodic_orbits(Feedback(plant(), BOTH), [(1.0, 2.0)]),
        TypeError,
        "forced_orbit takes a state as guess",
    ),
    "no prediction": (
        lambda: trimmer.limit_cycles(Feedback(plant(), BOTH)),
        TypeError,
        "several elements or frictions; harmonic_balance, periodic_orbits and respond find its motions",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_is_refused_with_what_to_do(case: str) -> None:
    make, kind, message = REFUSED[case]
    with pytest.raises(kind, match=message):
        make()
