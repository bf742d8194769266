"""Which of the motions that several starts settle to are one: asked of ``respond``, ``basin`` and maps."""

import numpy as np
import pytest

from trimmer import Mechanism, MotionKind, basin, forced_orbit, respond
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin
from trimmer.response.results.same import same_orbit


def blocks(between: float) -> Mechanism:
    """Two equal blocks on a belt of 0.2 m/s, each on a spring, with a spring between them."""
    pads = {name: Friction(("belt", name), 0.5, 1.0) for name in ("left", "right")}
    springs = {f"of {name}": Link(("ground", name), 1.0) for name in ("left", "right")}
    return Mechanism(
        {"left": Body(1.0), "right": Body(1.0)},
        pins={"belt": Pin("ground", velocity=0.2)},
        links={**springs, "between": Link(("left", "right"), between)},
        frictions=pads,
        outputs={name: Output({name: 1.0}) for name in ("left", "right")},
    )


@pytest.mark.slow
def test_orbits_of_one_period_are_told_apart_by_which_block_goes_first() -> None:
    """From rest both blocks are in step for ever; others come to left before right, or right before left."""
    response = respond(blocks(0.1), starts=5)
    assert len(response.motions) == 3
    one, other = (motion.orbit for motion in response.motions if motion.orbit is not None)
    assert one.stable
    assert one.period == pytest.approx(other.period, rel=1e-9)
    assert not same_orbit(one, other)
    states = other.instant.state[[1, 0, 3, 2]]
    swapped = forced_orbit(blocks(0.1), guess=states)
    assert same_orbit(one, swapped), "the image in which the blocks change places"


@pytest.mark.slow
def test_an_orbit_is_the_same_wherever_it_begins() -> None:
    orbit = forced_orbit(blocks(1.0))
    times = orbit.period * np.random.default_rng(3).uniform(size=2)
    for state in orbit.course.states(np.sort(times))[:, :4]:
        other = forced_orbit(blocks(1.0), guess=state)
        assert other.period == pytest.approx(orbit.period, rel=1e-9)
        assert same_orbit(orbit, other)
        assert same_orbit(other, orbit)


def spring(**parts) -> Mechanism:
    return Mechanism(
        {"body": Body(1.0)},
        links={"spring": Link(("ground", "body"), 4.0)},
        outputs={"body": Output({"body": 1.0})},
        **parts,
    )


def test_undamped_orbits_are_one_if_they_have_one_size() -> None:
    first, later, larger = (
        forced_orbit(spring(), guess={"body": pair}) for pair in ((0.3, 0.8), (0.5, 0.0), (0.501, 0.0))
    )
    assert same_orbit(first, later)
    assert not same_orbit(first, larger)
    assert len(respond(spring(), state={"body": (1.0, 0.0)}, starts=4).motions) == 4


def test_rests_that_one_friction_holds_are_one_family() -> None:
    held = spring(frictions={"floor": Friction(("ground", "body"), 0.5)})
    response = respond(held, state={"body": (2.0, 1.0)}, starts=5)
    assert response.kind is MotionKind.REST
    assert len(response.motions) == 1
    assert response.message.endswith("All 5 starts come to rest so.")


def test_a_basin_of_rest_has_one_motion_and_one_of_undamped_motion_has_many() -> None:
    values = {"body.displacement": [0.1, 0.2], "body.velocity": [0.0, 0.3]}
    held = spring(
        frequency=1.0,
        frictions={"floor": Friction(("ground", "body"), 5.0)},
        forces={"push": Force("body", amplitude=1.0)},
    )
    resting = basin(held, values, quiet=True)
    assert [motion.kind for motion in resting.motions] == [MotionKind.REST]
    assert resting.names == ("1: rest",)
    assert resting.result.kind[0, 0] is MotionKind.REST
    free = spring(frequency=1.0, forces={"push": Force("body", amplitude=1.0)})
    beating = basin(free, values, quiet=True)
    assert [motion.kind for motion in beating.motions] == [MotionKind.TORUS] * 4
    exact = respond(free, state={"body": (0.2, 0.3)}).motion.peak_to_peak["body"]
    assert beating.result.stroke[1, 1] == pytest.approx(exact, rel=1e-12)
