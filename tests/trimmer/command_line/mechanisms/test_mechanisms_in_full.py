"""Every number that commands tell of mechanisms, as JSON and as text, of results that are made by hand."""

from __future__ import annotations

import json
from dataclasses import dataclass
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells, point_of_branch
from trimmer.branches.special import SpecialKind
from trimmer.command_line.mechanisms import follow_text, map_text, respond_text
from trimmer.command_line.mechanisms import motion_text as of_mechanism
from trimmer.response.estimate import Estimate


def point(value: float) -> Made:
    return point_of_branch(value, stable=False, converged=False)


def branch(**changes: object) -> Made:
    usual = {
        "map": Made(place="frequency", mechanism=Made(frequency=60.0, outputs={"x": 1})),
        "unit": "Hz",
        "periods": 2,
        "reason": Made(word="end-of-range"),
        "success": True,
        "message": "over",
        "searched": "all",
        "parted": None,
        "points": [point(1.0), point(3.0)],
        "special": [],
        "branches": [],
    }
    return Made(**usual | changes)


def test_a_branch_is_in_the_json_with_those_that_part() -> None:
    special = Made(kind=SpecialKind.FOLD, value=2.5, parts=("wall",), note="it turns")
    told = {"kind": SpecialKind.FOLD.word, "value": 2.5, "parts": ["wall"], "note": "it turns"}
    other = branch(parted=special, points=[], success=False)
    data = json.loads(follow_text.as_json(branch(special=[special], branches=[other]), 3))
    (parted,) = data.pop("branches")
    assert (parted["parted"], parted["points"], parted["success"]) == (told, [], False)
    first, second = data.pop("points")
    assert first == {
        "value": 1.0,
        "period": 0.5,
        "stable": False,
        "multipliers": [[0.5, -0.25]],
        "events_per_period": 2,
        "outputs": {"x": {"advance": 0.5, "peak_to_peak": 4.0, "harmonics": [2.0, 1.0]}},
        "balance": {"distance": 3.0, "converged": False},
    }
    assert second["value"] == 3.0
    assert data == {
        "place": "frequency",
        "unit": "Hz",
        "period_count": 2,
        "reason": "end-of-range",
        "success": True,
        "message": "over",
        "searched": "all",
        "parted": None,
        "special": [told],
    }


@dataclass(frozen=True)
class Settings:
    seed: int = 7


def made_map() -> Made:
    grid = np.array([[1.0, np.nan, 3.0], [4.0, np.inf, 6.0]])
    names = ("largest_multiplier", "lyapunov", "events", "impacts", "impact_speed")
    return Made(
        **{name: (number + 1) * grid for number, name in enumerate(names)},
        inputs=Made(mechanism=Made(title="title"), settings=Settings()),
        places=("a", "b"),
        values=(np.array([1.0, 2.0, 3.0]), np.array([10.0, 20.0])),
        kind=[[Made(word="periodic")] * 3, [Made(word="chaotic")] * 3],
        period_count=np.array([[1, 2, 3], [0, 0, 0]]),
        periods=np.array([[5, 6, 7], [8, 9, 10]]),
        motion_count=np.array([[1, 2, 3], [4, 5, 6]]),
        peak_to_peak={"x": 10 * grid},
        rms_acceleration={"m": 20 * grid},
        wear_power={"f": 30 * grid},
        failures={(1, 2): "it fails"},
        passing="3 cells are chaotic",
    )


def rows(factor: float) -> list[list[float | None]]:
    return [[factor, None, 3 * factor], [4 * factor, None, 6 * factor]]


def test_a_map_is_in_the_json_row_by_row() -> None:
    assert json.loads(map_text.as_json(made_map(), "all")) == {
        "title": "title",
        "places": ["a", "b"],
        "values": [[1.0, 2.0, 3.0], [10.0, 20.0]],
        "settings": {"seed": 7},
        "kind": [["periodic"] * 3, ["chaotic"] * 3],
        "period_count": [[1, 2, 3], [None, None, None]],
        "drive_periods": [[5, 6, 7], [8, 9, 10]],
        "motion_count": [[1, 2, 3], [4, 5, 6]],
        "largest_multiplier": rows(1.0),
        "lyapunov": rows(2.0),
        "events_per_period": rows(3.0),
        "impacts_per_period": rows(4.0),
        "impact_speed": rows(5.0),
        "outputs": {"x": {"peak_to_peak": rows(10.0)}},
        "bodies": {"m": {"rms_acceleration": rows(20.0)}},
        "frictions": {"f": {"wear_power": rows(30.0)}},
        "failures": [{"row": 1, "column": 2, "message": "it fails"}],
        "passing": "3 cells are chaotic",
        "searched": "all",
        "special": None,
    }


def test_curves_over_a_map_are_in_the_json() -> None:
    side = Made(reason=Made(word="left"), message="it leaves")
    curve = Made(
        kind=Made(word="fold"), parts=("wall",), periods=3, values=np.eye(2), residual=1e-9, ends=[side]
    )
    meeting = Made(curves=(0, 1), values=np.array([1.5, 2.5]), ends=True, distance=0.25)
    special = Made(curves=[curve], meetings=[meeting], searched="lines")
    assert json.loads(map_text.as_json(made_map(), "all", special))["special"] == {
        "curves": [
            {
                "kind": "fold",
                "parts": ["wall"],
                "drive_periods": 3,
                "values": [[1.0, 0.0], [0.0, 1.0]],
                "residual": 1e-9,
                "ends": [{"reason": "left", "message": "it leaves"}],
            }
        ],
        "meetings": [{"curves": [0, 1], "values": [1.5, 2.5], "ends": True, "distance": 0.25}],
        "searched": "lines",
    }


def test_a_motion_is_told_in_full() -> None:
    energy = {
        "kinetic": (1.0, 3.0),
        "stored": (0.5, 7.0),
        "pins": {"pin": 10.0},
        "forces": {"push": 2.0},
        "dampers": {"oil": 1.5},
        "contacts": {"wall": 0.25},
        "frictions": {"blade": 1.75},
        "residual": 3e-16,
    }
    motion = Made(
        duration=0.5,
        outcome=Made(word="completed"),
        success=True,
        message="done",
        events=[Made(time=0.25, kind=Made(word="impact", value="impact"), part="wall")],
        mechanism=Made(outputs={"a": 1, "b": 2}),
        output=lambda name, times: {"a": 2.0, "b": -4.0}[name] * times,
        energy=Made(**energy, undetermined=()),
        undetermined_frictions=("blade",),
        rest=None,
    )
    data = json.loads(of_mechanism.as_json(motion))
    assert data.pop("last_amplitudes") == pytest.approx({"a": 0.05, "b": 0.1})
    assert data == {
        "duration": 0.5,
        "outcome": "completed",
        "success": True,
        "message": "done",
        "rest": None,
        "events": [{"time": 0.25, "kind": "impact", "part": "wall"}],
        "energy": energy | {"kinetic": [1.0, 3.0], "stored": [0.5, 7.0]},
        "undetermined_frictions": ["blade"],
    }
    lines = of_mechanism.as_text(motion).splitlines()
    assert lines[:2] == ["Motion of 0.5 s: done", "  wall: 1 x impact"]
    assert cells(lines[3:6]) == [["output", "m"], ["a", "0.05"], ["b", "0.1"]]
    assert lines[6].startswith("Energy over the whole motion")
    assert lines[-1].startswith("It closes to")


def test_what_wanders_is_told_over_its_window() -> None:
    motion = Made(
        orbit=None,
        rest=None,
        linear=None,
        window=1,
        events_per_period=2.25,
        harmonics={"x": np.array([3.0])},
        advance={"x": 0.0},
        peak_to_peak={"x": 5.0},
        rms={"x": Estimate(2.0, 0.0)},
        rms_acceleration={},
        message="It wanders.",
    )
    lines = respond_text.as_text(Made(message="First.", motions=[motion], starts=1)).splitlines()
    assert lines[0] == "First."
    assert lines[1] == "  2.25 events per drive period; figures are those of the window"
    assert cells(lines[3:4]) == [["x", "5", "2", "1: 3"]]
    assert cells(lines[4:]) == [["none"]] and "It wanders." not in lines
