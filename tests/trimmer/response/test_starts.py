"""Where motions begin, which of them are one, and the fields of what they settle to."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer import MechanismError, MotionKind, OrbitNotFoundError, WrongTypeError, forced_orbit, respond
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism import Body, Force, Link, Mechanism, Output
from trimmer.response.estimate import Estimate
from trimmer.response.measures import ContactMeasures, FrictionMeasures
from trimmer.response.respond import _random, _reached, _Search
from trimmer.response.response import Response, SettledMotion
from trimmer.response.response_json import _contacts, _frictions, motion_json
from trimmer.response.settling import orbit_from_rest
from trimmer.response.starts import instant_of

OMEGA = 7.5
DRIVEN = Mechanism(
    {"one": Body(1.0), "two": Body(0.5)},
    frequency=OMEGA / (2 * math.pi),
    links={"spring": Link(("ground", "one"), 40.0, 2.6), "strut": Link(("one", "two"), 90.0, 2.2)},
    forces={"push": Force("two", amplitude=100.0)},
    outputs={"two": Output({"two": 1.0})},
)
FLOW = ExactFlow(DRIVEN)


def test_a_start_is_rest_or_named_bodies_or_all_states_or_an_instant() -> None:
    assert instant_of(FLOW, None).state.tolist() == [0.0] * 4
    assert instant_of(FLOW, {"two": (0.3, -2.0)}).state.tolist() == [0.0, 0.3, 0.0, -2.0]
    instant = instant_of(FLOW, [1, 2, 3, 4])
    assert instant.state.tolist() == [1.0, 2.0, 3.0, 4.0]
    assert instant_of(FLOW, instant) is instant
    for wrong in ({"two": (1.0,)}, {"two": (1.0, 2.0, 3.0)}, {"two": 3.0}):
        with pytest.raises(WrongTypeError, match=r"the start of two must be \(m, m/s\)"):
            instant_of(FLOW, wrong)
    with pytest.raises(ValueError, match="velocity of two"):
        instant_of(FLOW, {"two": (0.0, math.inf)})
    with pytest.raises(ValueError, match="displacement of two"):
        instant_of(FLOW, {"two": (math.nan, 0.0)})
    with pytest.raises(MechanismError, match="mechanism has 4 states"):
        instant_of(FLOW, [1.0, 2.0])


def motion(kind=MotionKind.UNDECIDED, orbit=None, window=None, **changes) -> SettledMotion:
    return replace(SettledMotion(kind, orbit, window, 70, None, 1, 1.0, False, "Told."), **changes)


def orbit_of(states: list, periods: int = 1, period: float = 0.5) -> SimpleNamespace:
    sizes = np.array([1.0, 2.0, 3.0, 4.0])
    return SimpleNamespace(strobed=np.array(states), periods=periods, period=period, sizes=sizes)


def test_the_box_is_what_the_first_motion_reaches() -> None:
    damped = Mechanism(
        {"one": Body(1.0)},
        frequency=OMEGA / (2 * math.pi),
        links={"spring": Link(("ground", "one"), 40.0, 2.6)},
        forces={"push": Force("one", amplitude=100.0)},
    )
    amplitude = 100 / abs(40 - OMEGA**2 + 2.6j * OMEGA)
    expected = (pytest.approx(amplitude, rel=5e-3), pytest.approx(OMEGA * amplitude, rel=5e-3))
    assert respond(damped).box == {"one": expected}
    undamped = damped.with_value("links.spring.damping", 0.0)
    amplitude = 100 / abs(40 - OMEGA**2)
    free = amplitude * OMEGA / math.sqrt(40)
    assert respond(undamped).box["one"][0] == pytest.approx(amplitude + free, rel=1e-9)
    still = damped.with_value("forces.push.amplitude", 0.0)
    wide, fast = respond(still, state={"one": (0.3, -2.0)}).box["one"]
    assert 0.3 <= wide < math.hypot(0.3, 2.0 / math.sqrt(40))
    assert 2.0 <= fast < math.hypot(2.0, 0.3 * math.sqrt(40))
    sizes = np.array([1.0, 2.0, 3.0, 4.0, 9.0])
    watched = motion(window=SimpleNamespace(sizes=sizes))
    assert _reached(FLOW, watched, FLOW.rest()) == {"one": (1.0, 3.0), "two": (2.0, 4.0)}


def test_random_starts_fill_the_box_and_come_again() -> None:
    box = {"one": (0.1, 7.0), "two": (3.0, 0.0)}
    first, again, other = (
        np.array([each.state for each in _random(FLOW, box, 200, seed)]) for seed in (4, 4, 5)
    )
    assert first.shape == (200, 4)
    np.testing.assert_array_equal(first, again)
    assert (first != other).any()
    assert not first[:, 3].any()
    reach = np.array([0.1, 3.0, 7.0])
    assert (abs(first[:, :3]) <= reach).all()
    assert (first[:, :3].max(axis=0) > 0.95 * reach).all()
    assert (first[:, :3].min(axis=0) < -0.95 * reach).all()


def test_starts_are_counted_by_what_they_settle_to() -> None:
    chaotic, torus = motion(MotionKind.CHAOTIC), motion(MotionKind.TORUS)
    answers = iter([torus, chaotic, torus, torus, motion()])

    class Told(_Search):
        def motion(self, instant: object) -> SettledMotion:
            return next(answers)

    search = Told(FLOW, 10, [])
    found = search.grouped(chaotic, iter(range(5)))
    assert [each.kind for each in found] == [MotionKind.CHAOTIC, MotionKind.TORUS, MotionKind.UNDECIDED]
    assert [each.starts for each in found] == [2, 3, 1]
    assert [each.mirrored for each in found] == [False, False, False]
    response = Response(DRIVEN, tuple(found), 6, {}, 0)
    assert response.motion is found[0]
    assert response.kind is MotionKind.CHAOTIC
    assert response.success
    assert response.message == "Told. 6 starts settle to 3 motions; 100% of them to this one."
    assert Response(DRIVEN, (torus,), 6, {}, 0).message == "Told. All 6 starts settle to it."
    alone = Response(DRIVEN, (motion(),), 1, {}, 0)
    assert (alone.message, alone.success, alone.period_count) == ("Told.", False, None)


def test_a_motion_that_repeats_has_the_exponent_of_its_multiplier() -> None:
    measured = SimpleNamespace(rms=0.7, peak_to_peak=2.5, harmonics=np.array([1.0, 0.1]))
    measures = SimpleNamespace(outputs={"two": measured}, rms_acceleration={"one": 5.0})
    orbit = SimpleNamespace(periods=3, period_count=3, events_per_period=4.5, measures=measures)
    orbit.nontrivial_multipliers = np.array([0.2, -0.5j])
    found = motion(MotionKind.PERIODIC, orbit)
    assert found.lyapunov == Estimate(pytest.approx(math.log(0.5) / 3), 0.0)
    assert (found.period_count, found.events_per_period) == (3, 4.5)
    assert found.rms == {"two": Estimate(0.7, 0.0)}
    assert found.peak_to_peak == {"two": 2.5}
    assert found.harmonics["two"].tolist() == [1.0, 0.1]
    assert found.rms_acceleration == {"one": Estimate(5.0, 0.0)}
    held = SimpleNamespace(**{**vars(orbit), "nontrivial_multipliers": np.zeros(2)})
    assert motion(MotionKind.PERIODIC, held).lyapunov is None
    free = SimpleNamespace(**{**vars(orbit), "periods": 0})
    assert motion(MotionKind.PERIODIC, free).lyapunov is None


WINDOW = SimpleNamespace(
    exponents=(Estimate(0.3, 0.01), Estimate(-0.7, 0.02)),
    events=np.array([2.0, 5.0]),
    rms={"two": Estimate(0.7, 0.1)},
    output_means={"two": Estimate(0.2, 0.05)},
    advance={"two": 0.1},
    peak_to_peak={"two": 2.5},
    harmonics={"two": np.array([1.0, 0.1])},
    rms_acceleration={"one": Estimate(5.0, 0.2)},
    periods=512,
    spectrum=(np.array([0.0, 1.5]), {"two": np.array([0.1, 0.2])}),
)


def test_a_motion_that_does_not_repeat_has_the_numbers_of_its_window() -> None:
    found = motion(MotionKind.CHAOTIC, window=WINDOW, neighbour_agrees=True)
    assert found.lyapunov == Estimate(0.3, 0.01)
    assert (found.period_count, found.events_per_period) == (None, 3.5)
    assert (found.rms, found.peak_to_peak) == (WINDOW.rms, WINDOW.peak_to_peak)
    assert found.rms_acceleration == WINDOW.rms_acceleration
    content = motion_json(found)
    low, high = Estimate(0.7, 0.1).interval
    assert content["outputs"] == {
        "two": {
            "advance": 0.1,
            "mean": 0.2,
            "peak_to_peak": 2.5,
            "rms": 0.7,
            "rms_interval": [low, high],
            "harmonics": [1.0, 0.1],
            "subharmonics": [],
            "lines": [[1, 1, 1.0], [2, 1, 0.1]],
        }
    }
    low, high = Estimate(5.0, 0.2).interval
    assert content["bodies"] == {"one": {"rms_acceleration": 5.0, "rms_acceleration_interval": [low, high]}}
    assert content["lyapunov"] == {"value": 0.3, "uncertainty": 0.01}
    assert content["spectrum"] == {"frequencies": [0.0, 1.5], "densities": {"two": [0.1, 0.2]}}
    assert (content["kind"], content["window_periods"], content["drive_periods"]) == ("chaotic", 512, 70)
    assert (content["multipliers"], content["contacts"], content["frictions"]) == ([], {}, {})
    assert (content["period"], content["residual"], content["neighbour_agrees"]) == (None, None, True)


def test_a_motion_of_which_nothing_is_known_has_no_numbers() -> None:
    found = motion()
    assert (found.lyapunov, found.period_count, found.events_per_period) == (None, None, None)
    assert (found.rms, found.peak_to_peak, found.harmonics, found.rms_acceleration) == ({}, {}, {}, {})
    content = motion_json(found)
    assert (content["spectrum"], content["window_periods"], content["lyapunov"]) == (None, None, None)


def test_contacts_and_frictions_keep_all_their_numbers() -> None:
    measures = SimpleNamespace(
        contacts={"slot": ContactMeasures(2.0, (0.1, 0.4, 0.3), 7.0, 0.25)},
        frictions={"floor": FrictionMeasures(1.0, 110.0, 0.3)},
    )
    assert measures.contacts["slot"].impact_speed == 0.4
    assert ContactMeasures(0.0, (), 0.0, 0.0).impact_speed == 0.0
    assert _contacts(measures) == {
        "slot": {
            "impacts_per_period": 2.0,
            "impact_speeds": [0.1, 0.4, 0.3],
            "largest_force": 7.0,
            "share_of_time": 0.25,
        }
    }
    assert _frictions(measures) == {"floor": {"work_per_period": 1.0, "power": 110.0, "share_of_stick": 0.3}}


def test_kinds_are_told_in_few_words() -> None:
    assert MotionKind.PERIODIC.described(3) == "period 3"
    assert MotionKind.UNDECIDED.described(None) == "not settled"
    assert MotionKind.TORUS.described(None) == "torus"


def test_orbits_of_a_linear_mechanism_are_found_from_anywhere() -> None:
    rest, kicked = forced_orbit(DRIVEN), forced_orbit(DRIVEN, guess={"one": (5.0, -40.0)})
    np.testing.assert_allclose(kicked.instant.state, rest.instant.state, rtol=1e-9)
    assert kicked.instant.phase == 0.0
    settled = orbit_from_rest(DRIVEN, 500)
    np.testing.assert_allclose(settled.instant.state, rest.instant.state, rtol=1e-8)
    soon = orbit_from_rest(DRIVEN, 1)
    np.testing.assert_allclose(soon.instant.state, rest.instant.state, rtol=1e-9)
    response = respond(DRIVEN, starts=3, box={"one": (0.1, 0.2)})
    assert response.box == {"one": (0.1, 0.2)}
    assert [each.share for each in response.motions] == [1.0]
    assert response.motion.starts == 3
    assert response.motion.neighbour_agrees is None
    assert (response.seed, respond(DRIVEN).starts) == (0, 1)


def test_a_period_cannot_be_counted_without_a_drive() -> None:
    free = Mechanism({"one": Body(1.0)}, links={"spring": Link(("ground", "one"), 40.0, 1.0)})
    with pytest.raises(ValueError, match="no drive whose periods could count"):
        forced_orbit(free, periods=2)
    with pytest.raises(OrbitNotFoundError, match="comes to rest"):
        forced_orbit(free, periods=1)
    response = respond(free)
    assert response.kind is MotionKind.REST
    assert response.motion.drive_periods == 0
    assert (response.motion.starts, response.motion.share, response.motion.mirrored) == (1, 1.0, False)
    assert response.message.startswith("It comes to rest")


@pytest.mark.parametrize(("name", "least"), [("starts", 1), ("most_periods", 1), ("seed", 0)])
def test_the_least_numbers_are_allowed_and_no_less(name: str, least: int) -> None:
    assert respond(DRIVEN, **{name: least}).starts == 1
    with pytest.raises(ValueError, match=name):
        respond(DRIVEN, **{name: least - 1})
