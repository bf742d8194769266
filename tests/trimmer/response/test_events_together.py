"""Events at one instant: two equal machines side by side have the multipliers of one, each twice."""

from collections.abc import Callable

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from trimmer import Body, Force, Friction, Link, Mechanism, Pin, Play, Stop, respond, simulate
from trimmer.branches.period_maps.driven_map import DrivenMap

Parts = dict[str, Callable[[str], object]]
DRIVEN: Parts = {
    "links": lambda body: Link(("ground", body), stiffness=1.0, damping=0.2),
    "forces": lambda body: Force(body, amplitude=1.0),
}
AT_ONCE: dict[str, Parts] = {
    "stops": {"stops": lambda body: Stop(("ground", body), stiffness=20.0, damping=0.5, gap=0.5)},
    "frictions": {"frictions": lambda body: Friction(("ground", body), force=0.4)},
    "plays and frictions": {
        "plays": lambda body: Play(("ground", body), stiffness=9.0, damping=0.3, gap=0.6),
        "frictions": lambda body: Friction(("ground", body), force=0.2),
    },
}
ON_A_BELT: Parts = {
    "links": lambda body: Link(("ground", body), stiffness=1.0),
    "frictions": lambda body: Friction(("belt", body), force=0.5, static=1.0),
}


def machines(count: int, parts: Parts, frequency: float | None = 0.1) -> Mechanism:
    """Return equal machines of one body each that share the ground, the belt and the drive."""
    bodies = [f"body {number}" for number in range(count)]
    made = {section: {f"of {body}": part(body) for body in bodies} for section, part in parts.items()}
    pins = {} if frequency else {"belt": Pin("ground", velocity=0.2)}
    return Mechanism(frequency=frequency, bodies={body: Body(mass=1.0) for body in bodies}, pins=pins, **made)


@pytest.mark.parametrize(
    ("parts", "frequency"),
    [*((DRIVEN | each, 0.1) for each in AT_ONCE.values()), (ON_A_BELT, None)],
    ids=[*AT_ONCE, "blocks on a belt"],
)
def test_equal_machines_have_the_multipliers_of_one_twice(parts, frequency) -> None:
    one, two = (respond(machines(count, parts, frequency)).motion.orbit for count in (1, 2))
    assert one is not None and two is not None
    expected = np.sort(np.repeat(abs(one.multipliers), 2))
    # Beside a double multiplier rounding is that of its square root.
    np.testing.assert_allclose(np.sort(abs(two.multipliers)), expected, rtol=0, atol=1e-7)
    assert two.period == pytest.approx(one.period, rel=1e-9)
    assert not two.one_sided
    # Without a drive either machine may be ahead of the other for ever.
    assert (two.stable, two.neutral) == ((True, False) if frequency else (False, True))


@pytest.mark.parametrize("place", ['bodies."body 0".mass', 'forces."of body 0".amplitude'])
@pytest.mark.parametrize("parts", AT_ONCE.values(), ids=AT_ONCE)
def test_a_number_of_one_machine_moves_none_that_is_beside_it_in_step(parts, place) -> None:
    """All events of the two come in pairs; what changes in the first is no concern of the second."""
    machine = machines(2, DRIVEN | parts)
    orbit = respond(machine).motion.orbit
    value = machine.value(place)
    rate = DrivenMap(machine, place, value, orbit.periods).passage(value, orbit.strobed[0]).rate
    assert abs(rate[0::2]).max() > 0.1
    np.testing.assert_allclose(rate[1::2], 0.0, atol=1e-9)


@pytest.mark.slow
def test_frictions_of_bodies_that_hold_each_other_come_to_rest_together() -> None:
    """A body comes to rest beside one that is held and beside the ground: one event, also of a neighbour."""
    orbit = respond(random_mechanism(1118)).motion.orbit
    begin, columns = orbit.instant.state, []
    for size, direction in zip(orbit.sizes, np.eye(len(orbit.sizes)), strict=True):
        ends = [
            simulate(orbit.mechanism, orbit.period, state=begin + step * size * direction).states(
                orbit.period
            )
            for step in (1e-6, -1e-6)
        ]
        columns.append((ends[0] - ends[1]) / 2e-6 / orbit.sizes)
    differences = np.sort(abs(np.linalg.eigvals(np.array(columns).T)))[::-1]
    np.testing.assert_allclose(abs(orbit.multipliers[:3]), differences[:3], rtol=1e-6)
