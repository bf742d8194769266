"""The measures of a window, on samples and courses made by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import FORWARD, STICK
from trimmer.maps import measures
from trimmer.maps.measures import _highest, _of_events, _top_of_cubic, of_orbit, of_window, product
from trimmer.maps.settle import orbit_near


def test_the_top_of_a_cubic_is_between_its_samples() -> None:
    # v = 3 + 2 t - t³ from 0.25 to 1.25: highest at sqrt(2/3).
    times = np.array([0.0, 0.25, 1.25])
    values, rates = 3.0 + 2.0 * times - times**3, 2.0 - 3.0 * times**2
    top = 3.0 + 2.0 * math.sqrt(2.0 / 3.0) - (2.0 / 3.0) ** 1.5
    assert _top_of_cubic(times, values, rates, 1) == pytest.approx(top, rel=1e-13)
    assert _highest(times, values, rates) == pytest.approx(top, rel=1e-13)
    # v = 5 + t (t - 0.4) (t - 1) rises, falls and rises: the first turn is the higher one.
    turns = np.array([0.0, 1.0])
    first = (2.8 - math.sqrt(2.8**2 - 4.8)) / 6.0
    high = 5.0 + first * (first - 0.4) * (first - 1.0)
    found = _top_of_cubic(turns, np.array([5.0, 5.0]), np.array([0.4, 0.6]), 0)
    assert found == pytest.approx(high, rel=1e-12)
    # Without a turn between them it is the value at the first.
    rising = np.array([0.0, 0.1, 0.2])
    assert _top_of_cubic(rising, 3.0 + rising, np.ones(3), 1) == pytest.approx(3.1, rel=1e-14)
    assert _highest(rising, 3.0 + rising, np.ones(3)) == pytest.approx(3.2, rel=1e-14)


@pytest.mark.parametrize("at", [0.1, 0.9, 1.1, 2.4])
def test_the_highest_value_is_beside_the_highest_sample_on_either_side(at: float) -> None:
    times = np.array([0.0, 1.0, 2.5])
    values, rates = 7.0 - 3.0 * (times - at) ** 2, -6.0 * (times - at)
    assert _highest(times, values, rates) == pytest.approx(7.0, rel=1e-13)
    assert _highest(times, -values, -rates) == pytest.approx(max(-values), rel=1e-13)
    outside = np.array([3.0, 4.0, 5.5])
    assert _highest(outside, 7.0 - outside, -np.ones(3)) == 4.0


def test_functionals_of_states_are_a_row_for_each_state() -> None:
    states = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    assert product(states, np.array([[1.0, -1.0], [0.0, 2.0]])).tolist() == [
        [-1.0, 4.0],
        [-1.0, 8.0],
        [-1.0, 12.0],
    ]


def test_events_are_counted_for_each_drive_period() -> None:
    flow = ExactFlow(impact_oscillator())
    begin = flow.rest({"mass": (-25.0, 0.0)})
    course = flow.course(begin, 7)
    made = [(time, part) for time, part, kind in course.events if kind == 1]
    events, impacts, speed = _of_events(course, 7)
    assert len(made) > 2
    assert events == pytest.approx(len(course.events) / 7.0, rel=1e-15)
    assert impacts == pytest.approx(len(made) / 7.0, rel=1e-15)
    speeds = [abs(course.states(np.array([time]))[0, 1]) for time, _ in made]
    assert speed == pytest.approx(max(speeds), rel=1e-9)
    found = of_window(flow, course, 7)
    assert (found.events, found.impacts, found.impact_speed) == (events, impacts, speed)
    dense = course.states(np.linspace(0.0, course.duration, 40_001))
    assert found.peak_to_peak["x"] == pytest.approx(np.ptp(dense[:, 0]), rel=1e-6)
    assert of_orbit(flow, flow.course(begin, 7), 7).events == pytest.approx(events)


def test_a_window_has_the_mean_square_of_accelerations_and_of_no_output_nothing() -> None:
    flow = ExactFlow(replace(linear_oscillator(), outputs={}))
    orbit = orbit_near(flow, flow.rest(), 1)
    assert orbit is not None
    found = of_window(flow, flow.course(orbit.instant, 3), 3)
    amplitude = 100.0 / abs(40.0 - 7.5**2 + 0.1j * math.sqrt(40.0) * 7.5)
    # Even samples of a harmonic give its mean square exactly.
    assert found.rms_acceleration == {"mass": pytest.approx(7.5**2 * amplitude / math.sqrt(2.0), rel=1e-9)}
    assert found.peak_to_peak == {}
    assert (found.events, found.impacts, found.impact_speed) == (0.0, 0.0, 0.0)


def test_a_window_of_a_mechanism_with_one_mode_has_its_swings() -> None:
    flow = ExactFlow(linear_oscillator())
    orbit = orbit_near(flow, flow.rest(), 1)
    assert orbit is not None
    found = of_window(flow, flow.course(orbit.instant, 2), 2)
    amplitude = 100.0 / abs(40.0 - 7.5**2 + 0.1j * math.sqrt(40.0) * 7.5)
    assert found.peak_to_peak == {"x": pytest.approx(2.0 * amplitude, rel=1e-7)}


def test_dry_friction_wears_by_its_kinetic_force_where_it_slips(monkeypatch: pytest.MonkeyPatch) -> None:
    # Two frictions beside a contact; speeds are states 0 and 1, and the second sticks in the second half.
    monkeypatch.setattr(measures, "_accelerations", lambda *_: np.zeros((256, 1)))
    monkeypatch.setattr(measures, "_swings", lambda *_: {})
    monkeypatch.setattr(measures, "_of_events", lambda course, periods: (periods, 0.0, 0.0))
    asked = []

    def states(times: np.ndarray) -> np.ndarray:
        asked.append(times)
        return np.where(times < 1.5, 2.0, 4.0)[:, None] * [1.0, -1.0]

    log = SimpleNamespace(start=np.array([0.0, 1.5]), mode=np.array([7, 3]))
    course: Any = SimpleNamespace(log=log, duration=3.0, states=states)
    machine = SimpleNamespace(friction_rate=np.eye(2), stiffness=np.zeros(1), kinetic=np.array([5.0, 0.5]))
    statuses = np.full((8, 3), FORWARD)
    statuses[3, 2] = statuses[:, 0] = STICK
    modes = SimpleNamespace(
        machine=machine,
        tables=SimpleNamespace(statuses=statuses),
        layout=SimpleNamespace(frictions=("comb", "blade")),
    )
    mechanism = SimpleNamespace(bodies={"body": None}, frictions={"smooth": 0, "blade": 0, "comb": 0})
    flow: Any = SimpleNamespace(mechanism=mechanism, modes=modes)
    found = of_window(flow, course, 2)
    assert found.wear_power == {"smooth": 0.0, "blade": 0.5 * 2.0 / 2.0, "comb": 5.0 * 3.0}
    assert found.events == 2
    # Even samples amid their shares of the time, 128 for each drive period.
    (times,) = asked
    assert times == pytest.approx((np.arange(256) + 0.5) * 3.0 / 256.0, rel=1e-14)
