"""Windows made by hand, how long a motion is watched, and neighbours that leave, stay or agree."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer import MotionKind
from trimmer import respond as respond_to
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism import Body, Force, Link, Mechanism
from trimmer.response import respond, verdict
from trimmer.response.estimate import Estimate, mean_of
from trimmer.response.response_json import response_json
from trimmer.response.settling import Settling
from trimmer.response.verdict import _neighbour_leaves, look_closely
from trimmer.response.window import Window, joined, watch

DRIVEN = Mechanism(
    {"one": Body(1.0), "two": Body(0.5)},
    frequency=7.5 / (2 * math.pi),
    links={"spring": Link(("ground", "one"), 40.0, 2.6), "strut": Link(("one", "two"), 90.0, 2.2)},
    forces={"push": Force("two", amplitude=100.0)},
)
FLOW = SimpleNamespace(
    mechanism=SimpleNamespace(outputs={"x": 0, "y": 0}, bodies={"one": 0, "two": 0}), period=0.5
)
MEANS = np.array([[1.0, -2.0], [1.5, -4.0], [3.5, 0.0]])
SQUARES = np.array([[5.0, 30.0], [4.0, 20.0], [15.0, 10.0]])


def window(**changes) -> Window:
    """Three rows of two outputs and two bodies."""
    parts = {
        "flow": FLOW,
        "sizes": np.ones(4),
        "begin": "begin",
        "end": "end",
        "ending": Ending.REACHED_END,
        "growth": np.array([[0.1, -0.5], [0.3, -0.7], [0.2, -0.3]]),
        "means": MEANS,
        "squares": SQUARES,
        "waves": np.array([[[1.0, 2j]], [[1j, 4.0]], [[-1.0, 2j]]]),
        "ranges": np.array([[[0, 2], [-5, 1]], [[-1, 1], [-2, 3]], [[0.5, 2.5], [-1, 0]]]),
        "accelerations": np.array([[4.0, 9.0], [6.0, 9.0], [8.0, 9.0]]),
        "events": np.array([1.0, 2.0, 6.0]),
        "states": np.zeros((24, 4)),
        "samples": np.zeros((24 * 64, 2)),
    }
    return Window(**{**parts, **changes})


def test_the_numbers_of_a_window_are_those_of_its_rows() -> None:
    seen = window()
    assert seen.periods == 24
    assert [each.value for each in seen.exponents] == pytest.approx([0.2, -0.5])
    assert seen.exponents[1].uncertainty == pytest.approx(0.2 / math.sqrt(3))
    for place, name in enumerate(("x", "y")):
        mean = MEANS[:, place].mean()
        apart = mean_of(SQUARES[:, place] - 2 * mean * MEANS[:, place] + mean**2)
        root = math.sqrt(SQUARES[:, place].mean() - mean**2)
        assert seen.rms[name].value == pytest.approx(root)
        assert seen.rms[name].uncertainty == pytest.approx(apart.uncertainty / (2 * root))
    assert seen.harmonics["x"] == pytest.approx([1 / 3])
    assert seen.harmonics["y"] == pytest.approx([abs(4 + 4j) / 3])
    assert seen.peak_to_peak == {"x": 3.5, "y": 8.0}
    body = seen.rms_acceleration
    assert body["one"].value == pytest.approx(math.sqrt(6))
    assert body["one"].uncertainty == pytest.approx(2 / math.sqrt(3) / (2 * math.sqrt(6)))
    assert body["two"] == Estimate(3.0, 0.0)


def test_what_does_not_move_has_no_error() -> None:
    still = window(means=np.ones((3, 2)), squares=np.ones((3, 2)), accelerations=np.zeros((3, 2)))
    assert still.rms == {"x": Estimate(0.0, 0.0), "y": Estimate(0.0, 0.0)}
    assert still.rms_acceleration == {"one": Estimate(0.0, 0.0), "two": Estimate(0.0, 0.0)}
    below = window(means=np.ones((3, 2)), squares=np.full((3, 2), 1 - 1e-16))
    assert below.rms["x"].value == 0.0


def test_the_spectrum_has_one_density_for_each_output() -> None:
    steps = np.arange(24 * 64) / 64
    samples = np.array([3 * np.sin(2 * np.pi * 2 * steps), 5 * np.cos(2 * np.pi * 6 * steps)]).T
    frequencies, densities = window(samples=samples).spectrum
    for name, line, size in (("x", 4.0, 3.0), ("y", 12.0, 5.0)):
        assert frequencies[np.argmax(densities[name])] == pytest.approx(line)
        assert densities[name].sum() * frequencies[1] == pytest.approx(size**2 / 2, rel=1e-6)
    assert frequencies[1] == pytest.approx(2 / 24)
    assert len(frequencies) == 24 * 32 + 1


def test_two_windows_are_one_after_the_other() -> None:
    first, second = window(), window(events=np.array([9.0]), end="later", ending=Ending.DIVERGED)
    both = joined(first, second)
    assert both.events.tolist() == [1.0, 2.0, 6.0, 9.0]
    assert both.ranges.shape == (6, 2, 2)
    assert (both.begin, both.end, both.ending) == ("begin", "later", Ending.DIVERGED)
    assert both.sizes is first.sizes


def test_a_window_is_rounded_up_to_whole_rows() -> None:
    flow = ExactFlow(DRIVEN)
    seen = watch(flow, flow.rest(), 9)
    assert (seen.periods, seen.states.shape, seen.samples.shape) == (16, (16, 4), (1024, 0))
    np.testing.assert_allclose(seen.states, flow.strobe(flow.rest(), 15).states, rtol=1e-9, atol=1e-12)
    assert (seen.means.shape, seen.ranges.shape, seen.accelerations.shape) == ((2, 0), (2, 0, 2), (2, 2))
    np.testing.assert_allclose(seen.end.state, flow.strobe(flow.rest(), 16).states[-1], rtol=1e-9)
    assert seen.ending is Ending.REACHED_END
    assert (seen.rms, seen.peak_to_peak, seen.harmonics) == ({}, {}, {})
    frequencies, densities = seen.spectrum
    assert frequencies == pytest.approx(np.arange(513) / 16 / flow.period)
    assert densities == {}
    assert watch(flow, flow.rest(), 8).periods == 8


def test_what_has_no_outputs_and_does_not_settle_is_watched_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(verdict, "WINDOW", 64)
    free = Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 30.0)},
        forces={"push": Force("body", amplitude=1.0)},
    )
    response = respond_to(free, most_periods=32)
    assert response.motion.window.periods >= 64
    content = json.dumps(response_json(response), allow_nan=False)
    assert json.loads(content)["outputs"] == {}


def seen_by(monkeypatch: pytest.MonkeyPatch, windows: list) -> tuple[object, list]:
    """Watch windows that are given one after the other; return what was seen, and from where."""
    begun = []

    def given(flow: object, instant: object, periods: int):
        begun.append((instant, periods))
        return windows.pop(0)

    monkeypatch.setattr(verdict, "watch", given)
    monkeypatch.setattr(verdict, "_neighbour_leaves", lambda flow, window: False)
    flow = SimpleNamespace(modes=SimpleNamespace(layout=SimpleNamespace(bodies=("one", "two"))))
    return look_closely(flow, "here"), begun


def test_a_motion_is_watched_until_it_is_known_what_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    unknown = window(growth=np.array([[0.3, 0.0], [-0.3, 0.0], [0.1, 0.0]]))
    shrinking = window(growth=np.array([[-0.3, -0.4], [-0.3, -0.4], [-0.3, -0.4]]))
    found, begun = seen_by(monkeypatch, [unknown] * 9)
    assert found.window.periods == 4 * 24
    assert found.kind is MotionKind.UNDECIDED
    assert begun == [("here", 512), ("end", 512), ("end", 512), ("end", 512)]
    found, begun = seen_by(monkeypatch, [shrinking, unknown])
    assert found.contracts
    assert len(begun) == 1
    found, begun = seen_by(monkeypatch, [unknown, None, unknown])
    assert (found.window.periods, len(begun)) == (24, 2)
    longer = window(growth=unknown.growth, events=np.array([9.0, 8.0, 7.0]))
    found, _ = seen_by(monkeypatch, [unknown, longer, None])
    assert found.window.events.tolist() == [1.0, 2.0, 6.0, 9.0, 8.0, 7.0]
    assert seen_by(monkeypatch, [None])[0] is None
    assert not found.leaves


@pytest.mark.parametrize(("growth", "leaves"), [(900.0, False), (1100.0, True)])
def test_a_neighbour_leaves_where_its_distance_grows_a_thousandfold(growth: float, leaves: bool) -> None:
    sizes = np.array([1e-3, 50.0])
    rate = growth ** (1 / 256)

    def strobe(instant: SimpleNamespace, periods: int) -> SimpleNamespace:
        assert periods == 256
        return SimpleNamespace(states=instant.state * rate ** np.arange(periods + 1)[:, None])

    def at(state: np.ndarray, phase: float, like: object) -> SimpleNamespace:
        assert (phase, like) == (0.25, begin)
        moved = (state - begin.state) / sizes
        assert np.linalg.norm(moved) == pytest.approx(1e-9)
        direction = np.random.default_rng(2).normal(size=2)
        assert moved @ direction == pytest.approx(1e-9 * np.linalg.norm(direction))
        return SimpleNamespace(state=state)

    begin = SimpleNamespace(state=np.array([1e-3, -50.0]), phase=0.25)
    flow = SimpleNamespace(size=2, strobe=strobe, at=at, reduced=lambda states: states)
    assert _neighbour_leaves(flow, SimpleNamespace(begin=begin, sizes=sizes)) is leaves


def test_a_neighbouring_start_settles_to_the_same_or_not(monkeypatch: pytest.MonkeyPatch) -> None:
    flow = ExactFlow(DRIVEN)
    search = respond._Search(flow, 200, [])
    orbit = Settling(flow, flow.rest()).until_settled(200)
    assert search._agrees(flow.rest(), orbit, 50)
    assert not search._agrees(flow.rest(), None, 50)
    waited = []

    def never(settling: Settling, most: int) -> None:
        waited.append((most, settling.instant.state.copy()))

    monkeypatch.setattr(Settling, "until_settled", never)
    assert search._agrees(flow.rest(), None, 50)
    assert not search._agrees(flow.rest(), orbit, 150)
    assert [most for most, _ in waited] == [200, 250]
    sizes = respond.sizes_of(flow.course(flow.rest(), 1))
    np.testing.assert_allclose(waited[0][1], 1e-6 * sizes, rtol=1e-12)
