"""Mechanisms of many bodies, whose modes are no tables: each moves as it does alone, in little memory."""

import math
import tracemalloc
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
import pytest

from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Stop, UnsupportedMotionError
from trimmer.arrays import Reals
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.modes.system import MechanismSystem
from trimmer.hybrid.advance import advance
from trimmer.hybrid.stretch import Ending
from trimmer.hybrid.system import HOLD_BEGUN, EventFunction, JointEvent, ModeEquations
from trimmer.hybrid.tables import Modes
from trimmer.mechanism import GROUND, Wall
from trimmer.motion.course import Course

FREQUENCY = 50.0
COPIES = 16
PERIODS = 6


def copies(numbers: range) -> Mechanism:
    """Return oscillators that do not touch each other, each with a stop, a friction and its phase."""
    names = [f"body {number}" for number in numbers]
    laws = [tuple(ContactLaw)[number % len(ContactLaw)] for number in numbers]
    return Mechanism(
        bodies={name: Body(1.0) for name in names},
        links={name: Link((GROUND, name), stiffness=4e4, damping=5.0) for name in names},
        stops={
            f"stop {name}": Stop((GROUND, name), stiffness=5e5, damping=30.0, gap=2e-4, law=law)
            for name, law in zip(names, laws, strict=True)
        },
        frictions={
            f"pad {name}": Friction((GROUND, name), force=2.0, static=2.5 if number % 2 else None)
            for number, name in zip(numbers, names, strict=True)
        },
        forces={
            name: Force(name, amplitude=20.0, phase=0.37 * number)
            for number, name in zip(numbers, names, strict=True)
        },
        frequency=FREQUENCY,
    )


def motion(mechanism: Mechanism) -> Course:
    flow = MechanismFlow(mechanism)
    course = flow.course(flow.rest(), PERIODS)
    assert course.ending is Ending.REACHED_END
    return course


def test_each_of_many_moves_as_it_does_alone() -> None:
    together = motion(copies(range(COPIES)))
    monodromy, sizes = together.monodromy, abs(together.log.state).max(axis=0)
    layout = together.modes.system.layout
    for number in range(COPIES):
        alone = motion(copies(range(number, number + 1)))
        parts = number, COPIES + number
        events = [(time, parts.index(part), kind) for time, part, kind in together.events if part in parts]
        assert [event[1:] for event in events] == [event[1:] for event in alone.events]
        np.testing.assert_allclose(
            [event[0] for event in events], [event[0] for event in alone.events], atol=1e-10, rtol=0
        )
        name = alone.modes.system.layout.relaxing
        own = [number, COPIES + number, *(2 * COPIES + layout.relaxing.index(each) for each in name)]
        assert (abs(together.end.state[own] - alone.end.state) <= 1e-8 * sizes[own]).all()
        np.testing.assert_allclose(monodromy[np.ix_(own, own)], alone.monodromy, atol=1e-6, rtol=1e-6)
        times = np.linspace(0.0, together.duration, 50)
        apart = together.states(times)[:, own] - alone.states(times)[:, : len(own)]
        assert (abs(apart) <= 1e-8 * sizes[own]).all()


def test_a_wall_among_many_changes_small_distances_as_it_does_alone() -> None:
    walls = {"wall": Wall((GROUND, "body 0"), restitution=0.5, gap=1.5e-4)}
    together, alone = (motion(replace(copies(range(count)), walls=walls)) for count in (COPIES, 1))
    assert together.modes.tables.rows is not None
    assert alone.modes.tables.rows is None
    own = [0, COPIES]
    found, expected = together.monodromy[np.ix_(own, own)], alone.monodromy[:2, :2]
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-6 * abs(expected).max())


@pytest.mark.parametrize("place", ["stops.stop body 0.gap", "frictions.pad body 0.force"])
def test_the_derivative_by_a_number_of_one_among_many_is_that_of_it_alone(place: str) -> None:
    rates = []
    for count in (COPIES, 1):
        mechanism = copies(range(count))
        map, value = DrivenMap(mechanism, place, mechanism.value(place), 2), mechanism.value(place)
        rates.append(map.passage(value, np.zeros(map.size)).rate[[0, count]])
    np.testing.assert_allclose(*rates, rtol=1e-6, atol=1e-6 * abs(rates[1]).max())


@dataclass(frozen=True, eq=False)
class Counting(MechanismSystem):
    """Keeps for which event parts at rest decide together."""

    asked: list[EventFunction] = field(default_factory=list)

    def decide(self, mode: ModeEquations, state: Reals, event: JointEvent):
        self.asked.append(event.function)
        return super().decide(mode, state, event)


@pytest.mark.parametrize(("ground", "together"), [(True, False), (False, True)])
def test_frictions_decide_together_only_where_the_force_of_one_accelerates_the_ends_of_another(
    ground: bool, together: bool
) -> None:
    """What sticks on another body has no say: its events cost no more than those of a friction alone."""
    alone = copies(range(8))
    names = list(alone.bodies)
    between = {name: (GROUND if ground else other, name) for name, other in pairwise(names[::-1])}
    frictions = {name: Friction(ends, force=12.0) for name, ends in between.items()}
    flow = MechanismFlow(replace(alone, frictions=frictions))
    system = flow.modes.system
    counting = Counting(system.machine, system.layout)
    stretch = advance(Modes(counting), flow.rest(), PERIODS, flow.period, True)
    assert (stretch.counts[:, HOLD_BEGUN] > 1).any()
    assert bool(counting.asked) == together


@pytest.mark.slow
def test_many_modes_take_little_memory() -> None:
    flow = MechanismFlow(copies(range(20)))
    start = flow.rest()
    tracemalloc.start()
    course = flow.course(start, PERIODS)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    modes = {tuple(statuses) for statuses in course.modes.tables.statuses[course.log.mode].tolist()}
    # Tables of a step would take 1.5 MB for each mode.
    assert most < 0.2e6 * len(modes)
    assert math.isclose(course.duration, PERIODS / FREQUENCY)


@pytest.mark.parametrize("count", [4, 20])
def test_modes_that_would_take_too_much_memory_end_with_a_sentence(count: int) -> None:
    """Of few bodies modes are tables, of many they are rows; both are refused before they take the memory."""
    flow = MechanismFlow(copies(range(count)))
    modes = Modes(flow.modes.system, most_bytes=2**21)
    with pytest.raises(
        UnsupportedMotionError, match=r"more than \d+ combinations .* more than 0\.00195312 GB"
    ):
        advance(modes, flow.rest(), PERIODS, flow.period, False, 10_000)
    arrays = (*modes.tables, *(modes.tables.rows or ()))
    assert sum(each.nbytes for each in arrays if isinstance(each, np.ndarray)) <= 2**21
