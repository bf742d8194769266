"""What mechanisms settle to: repeating motions, tori and chaos, and how sure that is."""

import json
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import twin
from trimmer import Mechanism, MotionKind, UnsupportedMotionError, WrongTypeError, respond, simulate
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play, Stop
from trimmer.response.results.response_json import response_json

KEYS = {"kind", "period_count", "lyapunov", "drive_periods", "events_per_period", "multipliers"}
KEYS |= {"outputs", "bodies", "motions", "starts"}


def test_the_trimmer_settles_to_the_period_of_the_drive() -> None:
    response = respond(twin(1.0))
    content = response_json(response)
    assert response.success
    assert (response.kind, response.period_count) == (MotionKind.PERIODIC, 1)
    assert content["kind"] == "periodic"
    assert content["events_per_period"] == 14
    assert content["outputs"]["stroke"]["peak_to_peak"] == pytest.approx(2.933334121400e-3, rel=4e-13)
    assert content["bodies"]["motor"]["rms_acceleration"] == pytest.approx(118.754895, abs=6e-7)
    assert len(content["multipliers"]) == 9
    assert content.keys() >= KEYS
    assert json.loads(json.dumps(content, allow_nan=False)) == content


def test_it_is_where_the_motion_from_rest_is_after_a_long_time() -> None:
    mechanism = twin(2.0, 2e-4)
    orbit = respond(mechanism).motion.orbit
    times = np.array([598, 599, 600]) / mechanism.frequency
    late = simulate(mechanism, times[-1]).states(times).T
    apart = [abs((late - np.roll(orbit.strobed, shift, axis=0)) / orbit.sizes).max() for shift in range(3)]
    assert orbit.period_count == 3
    assert min(apart) < 1e-10


def test_at_another_speed_the_symmetry_is_lost() -> None:
    motion = respond(twin(2.0, 2e-4, 100.0)).motion
    assert motion.period_count == 1
    assert motion.harmonics["stroke"][1] > 1e-6


@pytest.mark.slow
def test_without_friction_it_is_chaotic() -> None:
    response = respond(twin(0.0, 2e-4), most_periods=200)
    exponent = response.motion.lyapunov
    assert response.kind is MotionKind.CHAOTIC
    assert response.period_count is None
    assert exponent.value - 3 * exponent.uncertainty > 0
    content = response_json(response)
    low, high = content["outputs"]["stroke"]["rms_interval"]
    assert low < content["outputs"]["stroke"]["rms"] < high
    assert content["multipliers"] == []
    assert content["drive_periods"] == 200 + content["window_periods"]
    assert "had not settled after 200 drive periods" in response.message
    json.dumps(content, allow_nan=False)


def test_what_friction_holds_rests_wherever_it_is_left() -> None:
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        frictions={"floor": Friction(("ground", "body"), 2.0)},
        forces={"push": Force("body", amplitude=1.0)},
        outputs={"body": Output({"body": 1.0})},
    )
    response = respond(mechanism, state={"body": (0.3, 0.0)})
    assert (response.kind, response.period_count, response.success) == (MotionKind.REST, None, True)
    assert response.motion.peak_to_peak["body"] == 0
    assert response.motion.rest.positions == {"body": 0.3}
    assert response.motion.rest.family
    assert response.motion.rest.forces["floor"] == pytest.approx(0.0, abs=1e-12)
    assert response.motion.rest.forces_change


def test_the_same_seed_gives_the_same_starts() -> None:
    first, second = (respond(twin(2.0, 2e-4), starts=3, seed=5) for _ in range(2))
    assert response_json(first) == response_json(second)


@pytest.mark.parametrize(
    ("call", "error", "named"),
    [
        (lambda: respond("twin"), WrongTypeError, "mechanism"),
        (lambda: respond(twin(), starts=0), ValueError, "starts"),
        (lambda: respond(twin(), most_periods=1.5), WrongTypeError, "most_periods"),
    ],
)
def test_what_cannot_be_used_is_named(call, error: type[Exception], named: str) -> None:
    with pytest.raises(error, match=named):
        call()


def test_what_a_pin_pulls_for_ever_diverges_and_what_may_leave_a_stop_is_refused() -> None:
    winch = Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        pins={"winch": Pin("ground", velocity=1.0)},
        links={"rope": Link(("winch", "body"), 1.0), "post": Link(("ground", "body"), 1.0)},
    )
    response = respond(winch, starts=3)
    assert (response.kind, response.motion.starts) == (MotionKind.DIVERGING, 3)
    assert "force grows without end" in response.message
    assert response_json(response)["kind"] == "diverging"
    stopped = replace(
        winch, links={"rope": winch.links["rope"]}, stops={"post": Stop(("ground", "body"), 1.0, 0.0, 1.0)}
    )
    with pytest.raises(UnsupportedMotionError, match="goes on for ever"):
        respond(stopped)


def test_what_cannot_be_followed_is_said() -> None:
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 1.0, 0.0)},
        frictions={"push": Friction(("ground", "body"), 0.0)},
        plays={"slot": Play(("ground", "body"), 1.0, 0.0, 0.1)},
        start={"body": (1e160, 0.0)},
    )
    response = respond(mechanism)
    assert response.kind is MotionKind.UNDECIDED
    assert "could be followed for 0 drive periods only" in response.message
    assert response_json(response)["outputs"] == {}
