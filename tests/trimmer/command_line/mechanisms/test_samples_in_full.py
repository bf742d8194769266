"""Every number that is told of samples, of mechanisms and of loops, of results that are made by hand."""

from __future__ import annotations

import json
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells
from trimmer.command_line.mechanisms import loop_sample_text, sample_text
from trimmer.design.targets import Measure
from trimmer.uncertainty.statistics import share_of
from trimmer.uncertainty.study import name_of

INDEX = Made(place="gap", first=0.5, first_error=0.125, total=0.75, total_error=np.nan)
INDEX_DATA = {"place": "gap", "first": 0.5, "total": 0.75, "first_error": 0.125, "total_error": None}
INDICES = Made(indices=[INDEX], message="the gap – alone")


def share(count: int, total: int = 4) -> dict[str, object]:
    found = share_of(count, total)
    return {"count": count, "share": count / total, "interval": [found.lowest, found.highest]}


def made_samples(**changes: object) -> Made:
    def trial(*met: str) -> Made:
        return Made(meets=lambda targets: all(each.key in met for each in targets))

    period, stroke, speed = (
        Made(measure=Measure.PERIOD, part=""),
        Made(measure=Measure.STROKE, part="x"),
        Made(measure=Measure.IMPACT_SPEED, part="wall"),
    )
    measured = {
        Measure.PERIOD: np.ones(4),
        Measure.STROKE: np.array([1.0, 5.0, np.nan, 3.0]),
        Measure.IMPACT_SPEED: np.full(4, np.nan),
    }
    scatters = [Made(place="gap", unit="m", assumed=True), Made(place="mass", unit="kg", assumed=False)]
    usual = {
        "inputs": Made(
            values=np.zeros((5, 2)),
            settings=Made(plan=Made(word="sobol"), seed=3, most_periods=77),
            uncertainty=Made(scatters=scatters),
        ),
        "impossible": 1,
        "failed": 2,
        "targets": [
            Made(key="stroke_min", part="x", bound=2.0),
            Made(key="period_max", part="", bound=1.0),
        ],
        "trials": [trial("stroke_min", "period_max"), trial("stroke_min"), trial("stroke_min"), trial()],
        "met": np.array([True, False, False, False]),
        "kinds": {"periodic": 3, "chaotic": 1},
        "asked": [period, stroke, speed],
        "measured": lambda asked: measured[asked.measure],
        "message": "4 samples – enough",
    }
    return Made(**usual | changes)


def made_study(**changes: object) -> Made:
    balanced = Made(
        harmonics=7, numbers=(0, 2), distances=np.array([0.5, 0.25]), converged=np.array([True, False])
    )
    usual = {
        "samples": made_samples(),
        "indices": {Key("stroke"): INDICES},
        "balanced": balanced,
        "per_second": 12.5,
    }
    return Made(**usual | changes)


class Key:
    def __init__(self, name: str) -> None:
        self.name = name


def test_samples_are_in_the_json() -> None:
    text = sample_text.as_json(made_study())
    assert "4 samples – enough" in text
    data = json.loads(text)
    stroke, speed = data.pop("measures")
    assert [stroke.pop(name) for name in ("measure", "part", "unit")] == ["stroke", "x", "m"]
    assert [stroke.pop(name) for name in ("count", "mean", "deviation")] == [3, 3.0, 2.0]
    middle = stroke.pop("quantiles")[1]
    assert (middle["share"], middle["value"]) == (0.5, 3.0)
    assert stroke == {}
    assert [speed[name] for name in ("measure", "part", "unit", "count")] == [
        "impact_speed",
        "wall",
        "m/s",
        0,
    ]
    assert data == {
        "count": 5,
        "impossible": 1,
        "failed": 2,
        "plan": "sobol",
        "seed": 3,
        "periods": 77,
        "scatters": [
            {"place": "gap", "unit": "m", "assumed": True},
            {"place": "mass", "unit": "kg", "assumed": False},
        ],
        "yield": share(1),
        "targets": [
            {"key": "stroke_min", "part": "x", "bound": 2.0, **share(3)},
            {"key": "period_max", "part": "", "bound": 1.0, **share(1)},
        ],
        "kinds": {"periodic": share(3), "chaotic": share(1)},
        "indices": [{"of": "stroke", "message": "the gap – alone", "numbers": [INDEX_DATA]}],
        "balance": {
            "harmonics": 7,
            "samples": [0, 2],
            "distances": [0.5, 0.25],
            "converged": [True, False],
        },
        "message": "4 samples – enough",
    }
    bare = made_study(samples=made_samples(targets=[]), balanced=None, indices={})
    data = json.loads(sample_text.as_json(bare))
    assert (data["yield"], data["targets"], data["balance"], data["indices"]) == (None, [], None, [])
    with pytest.raises(ValueError, match="not JSON compliant"):
        sample_text.as_json(made_study(samples=made_samples(failed=np.nan)))


def test_samples_are_told_section_by_section() -> None:
    yields, settled, measures, indices, balance, ending = sample_text.as_text(made_study()).split("\n\n")
    assert yields.startswith("all targets are met by 25.0% of 4")
    assert settled.splitlines()[0] == "what it settles to"
    assert [line.split()[:2] for line in settled.splitlines()[1:]] == [
        ["periodic", "75.0%"],
        ["chaotic", "25.0%"],
    ]
    lines = measures.splitlines()
    assert lines[0].startswith("how measures scatter")
    name = name_of(Made(measure=Measure.STROKE, part="x"))
    assert [row[:3] for row in cells(lines[2:])] == [[name, "3", "2"]]
    assert cells(lines[2:])[0][4].startswith("3 [") and cells(lines[2:])[0][-1] == "m"
    assert indices.splitlines()[0] == "what matters for stroke"
    assert indices.splitlines()[-1] == "  the gap – alone"
    assert balance.startswith("harmonic balance with 7 harmonics")
    assert ending == "4 samples – enough\n12.5 samples per second."
    bare = made_study(indices={}, balanced=None, per_second=np.inf)
    assert len(sample_text.as_text(bare).split("\n\n")) == 4
    assert sample_text.as_text(bare).endswith("\n\n4 samples – enough")


def made_loop_samples() -> Made:
    return Made(
        values=np.zeros((6, 2)),
        possible=np.array([True, True, True, True, False, False]),
        settings=Made(plan=Made(word="sobol"), seed=3),
        file=Made(uncertainty=Made(scatters=[Made(place="gap", unit="m")])),
        found=Made(
            exists=np.array([True, True, True, False]),
            count=np.array([2, 3, 2, 0]),
            searched_again=np.array([True, True, True, False]),
            undecided=np.array([False, True, False, True]),
        ),
        largest=(np.array([1.0, 5.0, 3.0, np.nan]), np.array([10.0, 50.0, 30.0, np.nan])),
        indices={"amplitude": INDICES},
        message="4 samples – enough",
        per_second=12.5,
    )


def test_samples_of_a_loop_are_in_the_json() -> None:
    text = loop_sample_text.as_json(made_loop_samples())
    assert "4 samples – enough" in text
    data = json.loads(text)
    amplitude, frequency = data.pop("amplitude"), data.pop("frequency")
    assert [amplitude[name] for name in ("count", "mean", "deviation")] == [3, 3.0, 2.0]
    assert [frequency[name] for name in ("count", "mean", "deviation")] == [3, 30.0, 20.0]
    assert data == {
        "count": 6,
        "impossible": 2,
        "plan": "sobol",
        "seed": 3,
        "scatters": [{"place": "gap", "unit": "m"}],
        "stable": share(3),
        "limit_cycles": {"0": share(1), "2": share(2), "3": share(1)},
        "searched_again": 3,
        "undecided": 2,
        "indices": [{"of": "amplitude", "message": "the gap – alone", "numbers": [INDEX_DATA]}],
        "message": "4 samples – enough",
    }
    wrong = made_loop_samples()
    wrong.settings.seed = np.nan
    with pytest.raises(ValueError, match="not JSON compliant"):
        loop_sample_text.as_json(wrong)


def test_samples_of_a_loop_are_told_section_by_section() -> None:
    stable, cycles, largest, indices, ending = loop_sample_text.as_text(made_loop_samples()).split("\n\n")
    assert stable.startswith("a stable limit cycle is predicted for 75.0% of 4")
    assert [line.split()[:2] for line in cycles.splitlines()[1:]] == [
        ["0", "25.0%"],
        ["2", "50.0%"],
        ["3", "25.0%"],
    ]
    lines = largest.splitlines()
    assert lines[0].startswith("the largest stable one")
    assert cells(lines[1])[0] == ["mean", "deviation", "5 %", "50 %", "95 %", "unit"]
    assert [(row[0], *row[1:3], row[-1]) for row in cells(lines[2:])] == [
        ("amplitude", "3", "2", "m"),
        ("frequency", "30", "20", "Hz"),
    ]
    assert indices.splitlines()[0] == "what matters for amplitude"
    assert indices.splitlines()[-1] == "  the gap – alone"
    assert ending == "4 samples – enough\n12.5 samples per second."
    nothing = made_loop_samples()
    nothing.largest = (np.full(4, np.nan), np.full(4, np.nan))
    assert loop_sample_text.as_text(nothing).split("\n\n")[2].splitlines()[1:] == ["  none"]
