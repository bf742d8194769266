"""Where motions begin, which starts are taken, and what is said of several of them."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import twin
from trimmer import MotionKind, OrbitNotFoundError, WrongTypeError, forced_orbit, respond, simulate
from trimmer.errors import MechanismError
from trimmer.mechanism import Body, Force, Friction, Link, Mechanism, Output, Stop
from trimmer.response.results.response_json import response_json

OMEGA = 7.5
DRIVEN = Mechanism(
    {"one": Body(1.0), "two": Body(0.5)},
    frequency=OMEGA / (2 * math.pi),
    links={"spring": Link(("ground", "one"), 40.0, 2.6), "strut": Link(("one", "two"), 90.0, 2.2)},
    forces={"push": Force("two", amplitude=100.0)},
    outputs={"two": Output({"two": 1.0})},
    start={"one": (0.1, 0.2)},
)


@pytest.mark.parametrize(
    ("state", "begun"),
    [
        (None, [0.1, 0.0, 0.2, 0.0]),
        ({"two": (0.3, -2.0)}, [0.1, 0.3, 0.2, -2.0]),
        ({"one": [0, 0]}, [0.0, 0.0, 0.0, 0.0]),
        ([1, 2, 3, 4], [1.0, 2.0, 3.0, 4.0]),
    ],
)
def test_a_start_is_the_mechanism_s_or_named_bodies_or_all_states(state: object, begun: list) -> None:
    motion = simulate(DRIVEN, 0.1, state=state)
    assert motion.states(0.0).tolist() == begun
    assert motion.flow.names == ("one", "two", "one'", "two'")


@pytest.mark.parametrize("door", [lambda s: simulate(DRIVEN, 1, state=s), lambda s: respond(DRIVEN, state=s)])
@pytest.mark.parametrize(
    ("state", "error", "named"),
    [
        ({"two": (1.0,)}, WrongTypeError, r"the start of two must be \(m, m/s\)"),
        ({"two": (1.0, 2.0, 3.0)}, WrongTypeError, r"the start of two must be \(m, m/s\)"),
        ({"two": 3.0}, WrongTypeError, r"the start of two must be \(m, m/s\)"),
        ({"two": (0.0, math.inf)}, ValueError, "velocity of two"),
        ({"two": (math.nan, 0.0)}, ValueError, "displacement of two"),
        ({"wheel": (0.0, 0.0)}, MechanismError, "'wheel', which is no body"),
        ([1.0, 2.0], MechanismError, "mechanism has 4 states"),
    ],
)
def test_what_is_no_start_is_named(door, state: object, error: type[Exception], named: str) -> None:
    with pytest.raises(error, match=named):
        door(state)


def one(damping: float = 2.6, amplitude: float = 100.0, **changes: object) -> Mechanism:
    return Mechanism(
        {"one": Body(1.0)},
        frequency=OMEGA / (2 * math.pi),
        links={"spring": Link(("ground", "one"), 40.0, damping)},
        forces={"push": Force("one", amplitude=amplitude)},
        **changes,
    )


def test_the_box_of_random_starts_is_what_the_first_motion_reaches() -> None:
    amplitude = 100 / abs(40 - OMEGA**2 + 2.6j * OMEGA)
    expected = (pytest.approx(amplitude, rel=5e-3), pytest.approx(OMEGA * amplitude, rel=5e-3))
    assert respond(one()).box == {"one": expected}
    amplitude = 100 / abs(40 - OMEGA**2)
    free = amplitude * OMEGA / math.sqrt(40)
    assert respond(one(0.0)).box["one"][0] == pytest.approx(amplitude + free, rel=1e-9)
    wide, fast = respond(one(amplitude=0.0), state={"one": (0.3, -2.0)}).box["one"]
    assert 0.3 <= wide < math.hypot(0.3, 2.0 / math.sqrt(40))
    assert 2.0 <= fast < math.hypot(2.0, 0.3 * math.sqrt(40))


def test_random_starts_fill_the_box_and_come_again() -> None:
    """Each start of an undamped oscillator has a size of its own, which lies within that of the corner."""
    undamped = Mechanism(
        {"one": Body(1.0)},
        links={"spring": Link(("ground", "one"), 1.0)},
        outputs={"x": Output({"one": 1.0})},
    )

    def sizes(seed: int) -> np.ndarray:
        box = {"one": (3.0, 4.0)}
        response = respond(undamped, state={"one": (9.0, 0.0)}, starts=12, box=box, seed=seed)
        assert (response.box, response.starts, response.seed) == (box, 12, seed)
        assert [each.share for each in response.motions] == [pytest.approx(1 / 12)] * 12
        return np.array([each.peak_to_peak["x"] / 2 for each in response.motions])

    first, again, other = (sizes(seed) for seed in (4, 4, 5))
    assert first.tolist() == again.tolist()
    assert first[0] == pytest.approx(9.0)
    assert not np.allclose(first[1:], other[1:])
    assert 3.5 < first[1:].max() <= 5.0 + 1e-9
    assert first[1:].min() < 2.0


def test_orbits_of_a_linear_mechanism_are_found_from_anywhere() -> None:
    rest, kicked = forced_orbit(DRIVEN), forced_orbit(DRIVEN, guess={"one": (5.0, -40.0)})
    np.testing.assert_allclose(kicked.instant.state, rest.instant.state, rtol=1e-9)
    settled = forced_orbit(DRIVEN, settling=500)
    np.testing.assert_allclose(settled.instant.state, rest.instant.state, rtol=1e-8)
    response = respond(DRIVEN, starts=3, box={"one": (0.1, 0.2)})
    assert response.box == {"one": (0.1, 0.2)}
    assert [(each.share, each.starts) for each in response.motions] == [(1.0, 3)]
    assert response.motion.neighbour_agrees is None
    assert response.message.endswith("All 3 starts settle to it.")


@pytest.mark.parametrize("weight", [0.0, 5e-3])
def test_mirrored_twins_are_told_only_of_what_is_symmetric(weight: float) -> None:
    mechanism = twin(2.0, 2e-4, 100.0)
    pulled = replace(mechanism, forces={"weight": Force("cutter", constant=weight)})
    response = respond(pulled, starts=4, seed=1)
    content = response_json(response)
    shares = [motion["share"] for motion in content["motions"]]
    assert sum(shares) == pytest.approx(1)
    assert len(shares) > 1
    assert any(motion["mirrored"] for motion in content["motions"]) is (weight == 0.0)
    told = f"4 starts settle to {len(shares)} motions; {shares[0]:.0%} of them to this one."
    assert response.message.endswith(told)
    assert response.to_dataframe()["share"].tolist() == shares
    strokes = [motion["outputs"]["stroke"]["peak_to_peak"] for motion in content["motions"][:2]]
    assert (abs(strokes[0] - strokes[1]) < 1e-12) is (weight == 0.0)


def test_without_a_drive_there_are_no_periods_to_count() -> None:
    free = Mechanism({"one": Body(1.0)}, links={"spring": Link(("ground", "one"), 40.0, 1.0)})
    with pytest.raises(ValueError, match="no drive whose periods could count"):
        forced_orbit(free, periods=2)
    with pytest.raises(OrbitNotFoundError, match="comes to rest"):
        forced_orbit(free, periods=1)
    response = respond(free)
    assert response.kind is MotionKind.REST
    assert (response.motion.drive_periods, response.motion.starts, response.motion.share) == (0, 1, 1.0)
    assert response.message.startswith("It comes to rest")


@pytest.mark.parametrize(("name", "least"), [("starts", 1), ("most_periods", 1), ("seed", 0)])
def test_the_least_numbers_are_allowed_and_no_less(name: str, least: int) -> None:
    assert respond(DRIVEN, **{name: least}).starts == 1
    with pytest.raises(ValueError, match=name):
        respond(DRIVEN, **{name: least - 1})


@pytest.mark.parametrize(("name", "least"), [("settling", 0), ("periods", 1)])
def test_an_orbit_has_whole_periods(name: str, least: int) -> None:
    assert forced_orbit(DRIVEN, **{name: least}).success
    with pytest.raises(ValueError, match=name):
        forced_orbit(DRIVEN, **{name: least - 1})


def test_an_orbit_that_is_not_found_is_no_success_and_what_cannot_be_followed_is_named() -> None:
    floor = {"floor": Friction(("ground", "one"), 1.0)}
    pushed = Mechanism({"one": Body(1.0)}, 2.0, frictions=floor, forces={"push": Force("one", constant=3.0)})
    missed = forced_orbit(pushed, periods=2)
    assert not (missed.success or missed.stable or missed.neutral)
    assert missed.residual > 1e-4
    told = "no motion that returns after 2 drive periods was found; the closest misses"
    assert missed.message.startswith(told)
    with pytest.raises(OrbitNotFoundError, match="cannot be followed"):
        forced_orbit(one(stops={"w": Stop(("ground", "one"), 1.0)}, start={"one": (1e160, 0.0)}))


@pytest.mark.parametrize(("kind", "period", "told"), [
    (MotionKind.PERIODIC, 3, "period 3"), (MotionKind.UNDECIDED, None, "not settled"),
    (MotionKind.TORUS, None, "torus"),
])  # fmt: skip
def test_kinds_are_told_in_few_words(kind: MotionKind, period: int | None, told: str) -> None:
    assert kind.described(period) == told
