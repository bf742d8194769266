"""What is handed on of motions that were found: to comparisons, to JSON and to pictures."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer import MotionKind
from trimmer.response import respond
from trimmer.response.measures import ContactMeasures, FrictionMeasures, OutputMeasures
from trimmer.response.respond import _Search
from trimmer.response.response import Response, SettledMotion
from trimmer.response.response_json import motion_json, response_json

LINES = np.array([3j, -4.0, 1.5, 2.0])


def periodic(name: str = "orbit") -> SettledMotion:
    measures = SimpleNamespace(
        outputs={"x": OutputMeasures(-1.0, 4.0, 0.5, 1.25, LINES, 2, 0.25)},
        rms_acceleration={"one": 5.0},
        contacts={"slot": ContactMeasures(2.0, (0.1, 0.4), 7.0, 0.25)},
        frictions={"floor": FrictionMeasures(1.0, 110.0, 0.3)},
    )
    orbit = SimpleNamespace(
        name=name, multipliers=np.array([0.5 + 0.25j, -0.125]), periods=2, period_count=2, period=0.75,
        residual=1e-12, events_per_period=3.5, measures=measures, course=None, flow=None,
        nontrivial_multipliers=np.array([0.5 + 0.25j, -0.125]), edge=None, one_sided=False,
    )  # fmt: skip
    return SettledMotion(MotionKind.PERIODIC, orbit, None, 70, True, 3, 0.75, False, "Told.")


def test_json_holds_all_that_is_known_of_an_orbit() -> None:
    content = motion_json(periodic())
    assert content["multipliers"] == [[0.5, 0.25], [-0.125, 0.0]]
    lines = [[1, 2, 3.0], [2, 2, 4.0], [3, 2, 1.5], [4, 2, 2.0]]
    assert content["outputs"] == {
        "x": {
            "advance": 0.25,
            "mean": 0.5,
            "peak_to_peak": 5.0,
            "rms": 1.25,
            "rms_interval": [1.25, 1.25],
            "harmonics": [4.0, 2.0],
            "subharmonics": [3.0],
            "lines": lines,
        }
    }
    assert content["bodies"] == {"one": {"rms_acceleration": 5.0, "rms_acceleration_interval": [5.0, 5.0]}}
    assert (content["period"], content["residual"], content["period_count"]) == (0.75, 1e-12, 2)
    assert list(content["contacts"]) == ["slot"]
    assert list(content["frictions"]) == ["floor"]
    assert (content["spectrum"], content["window_periods"], content["events_per_period"]) == (None, None, 3.5)
    mechanism = SimpleNamespace(title="it", outputs={"x": None})
    response = Response(
        mechanism, (periodic(), replace(periodic(), mirrored=True)), 4, {"one": (1.0, 2.0)}, 9
    )
    told = response_json(response)
    assert (told["starts"], told["box"], told["seed"]) == (4, {"one": [1.0, 2.0]}, 9)
    assert [(each["share"], each["mirrored"]) for each in told["motions"]] == [(0.75, False), (0.75, True)]


def test_the_table_has_a_row_for_each_motion() -> None:
    mechanism = SimpleNamespace(title="it", outputs={"x": None, "y": None})
    other = SettledMotion(MotionKind.UNDECIDED, None, None, 7, None, 1, 0.25, True, "Told.")
    table = Response(mechanism, (periodic(), other), 4, {}, 9)._table()
    assert list(table.units) == [
        *("kind", "period_count", "share", "mirrored", "drive_periods"),
        *("outputs.x.peak_to_peak", "outputs.y.peak_to_peak"),
    ]
    first, second = table.rows()
    assert first[1:] == (2, 0.75, False, 70, 5.0, None)
    assert second[1:] == (None, 0.25, True, 7, None, None)


@pytest.mark.parametrize(("periods", "waits"), [(150, 250), (900, 1000), (901, 1001)])
def test_a_neighbouring_start_has_other_places_and_velocities_but_no_other_stretches(
    monkeypatch: pytest.MonkeyPatch, periods: int, waits: int
) -> None:
    begun: list = []

    class Settled:
        def __init__(self, flow, instant, known):
            begun.append((instant.tolist(), known))

        def until_settled(self, most):
            begun.append(most)
            return "other"

    monkeypatch.setattr(respond, "Settling", Settled)
    monkeypatch.setattr(respond, "sizes_of", lambda course: np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))
    monkeypatch.setattr(respond, "same_orbit", lambda orbit, other: (orbit, other) == ("orbit", "other"))
    layout = SimpleNamespace(bodies=("one", "two"))
    flow = SimpleNamespace(
        modes=SimpleNamespace(layout=layout),
        course=lambda instant, count: (instant, count),
        at=lambda state, like: state,
    )
    start = SimpleNamespace(state=np.arange(6.0))
    search = _Search(flow, max(waits - 1, 250) if periods == 901 else waits, ["known"])
    assert search._agrees(start, "orbit", periods)
    states, known = begun[0]
    assert states == pytest.approx([1e-6, 1 + 2e-6, 2 + 3e-6, 3 + 4e-6, 4.0, 5.0], rel=1e-14)
    assert known == ["known"]
    assert begun[1] == waits
    assert start.state.tolist() == list(range(6))
    assert not search._agrees(start, "another", periods)


def test_pictures_are_given_what_they_draw(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list = []
    monkeypatch.setattr(
        "trimmer.drawing.mechanisms.response.draw_settled", lambda *given: drawn.append(given) or "axes"
    )
    response = Response(None, (periodic(),), 1, {}, 0)
    assert response.plot("ax") == "axes"
    assert response.plot() == "axes"
    assert drawn == [(response.motion, "ax"), (response.motion, None)]
