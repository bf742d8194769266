"""What the examples settle to from rest; results survive pickling."""

import pickle
from itertools import pairwise

import pytest

from tests.trimmer.response.mechanisms import FOLDER, example
from trimmer import MotionKind, respond, simulate
from trimmer.response.results.response_json import response_json

REPEATING = {
    "thesis": 0,
    "thesis-play": 14,
    "scatter": 14,
    "held": 6,
    "foil-shaver": 14,
    "servo": 16,
    "den-hartog": 2,
    "conveyor": 2,
    "strip-feeder": 4,
    "block-on-belt": 2,
    "two-mass-stop": 0,
    "oscillator-stop": 0,
    "gear-pair": 0,
    "gear-rattle": 8,
    "housing-modes": 4,
    "lever-valve": 6,
    "cam-drive": 2,
    "bouncing-ball": 1,
    "brake-squeal": 2,
    "stiction-pid": 4,
    "two-mass-servo": 12,
    "jigsaw": 10,
    "toothbrush": 12,
}
"""Examples that repeat with their drive, or by themselves, with their events per period."""
OTHERS = {"second-play", "thrown-body", "contactor", "sampled-axis"}
"""A torus, see ``test_respond``; a body that flies away; what is switched, and only simulated; what rests."""


def test_each_example_is_here() -> None:
    assert {path.stem for path in FOLDER.glob("*.toml")} == {*REPEATING, *OTHERS}


@pytest.mark.parametrize("name", REPEATING)
def test_an_example_repeats(name: str) -> None:
    response = respond(example(name))
    assert response.success
    assert (response.kind, response.period_count) == (MotionKind.PERIODIC, 1)
    assert response.motion.orbit.stable
    assert response.motion.events_per_period == REPEATING[name]


def test_what_flies_away_diverges() -> None:
    response = respond(example("thrown-body"))
    assert (response.kind, response.success) == (MotionKind.DIVERGING, True)
    assert "in proportion to the time" in response.message


def test_the_sampled_axis_comes_to_rest_at_its_reference() -> None:
    """No rounding is told as a force there."""
    axis = example("sampled-axis")
    for place, value in (("links.shaft.damping", 0.0144562), ("references.path.step", 0.1)):
        rest = respond(axis.with_value(place, value)).motion.rest
        step = axis.with_value(place, value).value("references.path.step")
        assert (rest.positions["motor"], rest.positions["load"]) == pytest.approx((step, step), rel=1e-9)
        assert not rest.forces_change and not any(rest.forces.values())


def test_the_contactor_bounces_twice_and_opens_again() -> None:
    motion = simulate(example("contactor"), 0.12)
    made = [each for each in motion.events if (each.part, each.kind.word) == ("contact", "contact-made")]
    assert [each.time > 0.008 for each in made] == [True] * 3
    assert [a.speed > b.speed for a, b in pairwise(made)] == [True] * 2
    assert motion.rest.forces["contact"] == 0.0


def test_results_are_the_same_after_pickling() -> None:
    response, motion = respond(example("held")), simulate(example("held"), 0.05)
    assert response_json(pickle.loads(pickle.dumps(response))) == response_json(response)
    again = pickle.loads(pickle.dumps(motion))
    assert again.events == motion.events
    assert again.energy == motion.energy
