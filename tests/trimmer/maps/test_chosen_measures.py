"""Measures by their keys: those of the JSON of a response, in maps and on branches; what there is not."""

from dataclasses import replace
from functools import reduce
from operator import getitem
from typing import Any

import pytest

from tests.trimmer.response.mechanisms import example, twin
from trimmer import FollowSettings, SerialRunner, follow, motion_map, respond
from trimmer.choices import ChoiceError
from trimmer.motion.chosen import chosen_measure
from trimmer.motion.measures import Measures
from trimmer.response.flows import flow_of
from trimmer.response.results.response_json import response_json

NASTY = 'a "b" = {c}.d'
KEYS = [
    *(f"outputs.stroke.{each}" for each in ("peak_to_peak", "rms", "mean", "advance")),
    "bodies.motor.rms_acceleration",
    *(f"contacts.bridge.{each}" for each in ("impacts_per_period", "largest_force", "share_of_time")),
    *(f"frictions.blade.{each}" for each in ("work_per_period", "power", "share_of_stick")),
    "events_per_period",
]


def test_keys_are_those_of_the_json_of_a_response() -> None:
    mechanism = twin(1.0)
    response = respond(mechanism)
    content: dict[str, Any] = response_json(response)
    measures, flow = response.motion.measures, flow_of(mechanism)
    assert measures is not None

    def of(key: str) -> float:
        return chosen_measure(flow, key).of(measures)

    for key in KEYS:
        assert of(key) == reduce(getitem, key.split("."), content)
    stroke = content["outputs"]["stroke"]
    third = pytest.approx(stroke["harmonics"][2], rel=1e-14)
    assert of("outputs.stroke.harmonics.3") == of("outputs.stroke.lines.3/1") == third
    assert of("outputs.stroke.lines.6/2") == third
    assert of("outputs.stroke.lines.1/2") == 0.0
    orbit = response.motion.orbit
    twice = Measures(flow.course(orbit.instant, 2), flow, 2, 2)
    assert chosen_measure(flow, "outputs.stroke.lines.3").of(twice) == pytest.approx(stroke["harmonics"][2])
    speed = max(content["contacts"]["bridge"]["impact_speeds"])
    assert of("contacts.bridge.impact_speed") == of("impact_speed") == speed
    assert (of("rattle"), of("impacts_per_period")) == (1.0, of("contacts.bridge.impacts_per_period"))
    assert [chosen_measure(flow, key).unit for key in ("impact_speed", KEYS[1], KEYS[9])] == ["m/s", "m", "W"]


def test_maps_and_branches_measure_what_is_asked_for() -> None:
    oscillator, keys = example("oscillator-stop"), ["contacts.stop.impact_speed", "rattle"]
    result = motion_map(oscillator, {"frequency": [0.9, 1.2]}, measures=keys, runner=SerialRunner())
    branch = follow(oscillator, "frequency", 0.9, 0.91, settings=FollowSettings(most_points=4, quiet=True))
    assert branch.points[0].measure(keys[0]) == pytest.approx(result.chosen[keys[0]][0, 0], rel=1e-9)
    assert result.chosen["rattle"].tolist() == [[1.0, 0.0]]
    assert f"measures.{keys[0]}" in result.to_dataframe().columns
    result.plot(measure=keys[0], target=10.0)
    branch.plot(measure=keys[0], target=10.0)


@pytest.mark.parametrize(
    ("key", "sentence"),
    [
        ("outputs.strok.rms", "did you mean outputs.stroke.rms"),
        ("outputs.stroke.harmonics.21", "there is no measure"),
        ("outputs.stroke.lines.1/0", "there is no measure"),
        ("noise", "such are outputs.stroke.peak_to_peak"),
    ],
)
def test_what_is_not_measured_is_refused(key: str, sentence: str) -> None:
    with pytest.raises(ChoiceError, match=sentence):
        motion_map(twin(1.0), {"frequency": [110.0]}, measures=[key])


def test_a_name_of_any_letters_stands_in_a_key_as_it_is() -> None:
    moving = example("oscillator-stop")
    output = next(iter(moving.outputs.values()))
    named = replace(moving, outputs={NASTY: output})
    chosen = chosen_measure(flow_of(named), f"outputs.{NASTY}.rms")
    assert chosen.of(respond(named).motion.measures) > 0
