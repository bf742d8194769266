from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.maps.machines import SQUARE_ROOT_OF_40, impact_oscillator, linear_oscillator
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine.statuses import CONTACT_MADE
from trimmer.maps.measures import of_orbit, of_window
from trimmer.maps.settle import settle
from trimmer.mechanism import Body, Friction, Link, Mechanism, Pin

TWIN = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "thesis-play.toml")


def measures_of(mechanism: Mechanism, measures=of_orbit):
    flow = MechanismFlow(mechanism)
    orbit = settle(flow, flow.rest(), 400).orbit
    return measures(flow, orbit.course, orbit.period_count)


def test_a_linear_oscillator_is_that_of_the_textbook() -> None:
    """Even samples of a harmonic give its mean square exactly; between them swings are cubics."""
    mechanism, omega = linear_oscillator(), 7.5
    amplitude = 100 / abs(40 - omega**2 + 0.1j * SQUARE_ROOT_OF_40 * omega)
    found = measures_of(mechanism, of_window)
    assert found.peak_to_peak["x"] == pytest.approx(2 * amplitude, rel=1e-7)
    assert found.rms_acceleration["mass"] == pytest.approx(omega**2 * amplitude / np.sqrt(2), rel=1e-7)
    assert (found.events, found.impacts, found.impact_speed) == (0, 0, 0)
    assert found.wear_power == {}


def test_even_samples_of_a_window_are_near_the_exact_measures() -> None:
    mechanism = TWIN.with_value("frictions.blade.force", 1.0)
    exact, even = measures_of(mechanism), measures_of(mechanism, of_window)
    assert even.peak_to_peak["stroke"] == pytest.approx(exact.peak_to_peak["stroke"], rel=1e-6)
    assert even.rms_acceleration["motor"] == pytest.approx(exact.rms_acceleration["motor"], rel=0.02)
    assert even.wear_power["blade"] == pytest.approx(exact.wear_power["blade"], rel=0.01)
    assert (even.events, even.impact_speed) == (exact.events, exact.impact_speed)


def test_events_of_a_window_are_counted_for_each_drive_period() -> None:
    flow = MechanismFlow(impact_oscillator())
    course = flow.course(flow.rest({"mass": (-25.0, 0.0)}), 7)
    made = [time for time, _, kind in course.events if kind == CONTACT_MADE]
    speeds = [abs(course.states(np.array([time]))[0, 1]) for time in made]
    found = of_window(flow, course, 7)
    assert len(made) > 2
    assert found.events == pytest.approx(len(course.events) / 7, rel=1e-15)
    assert found.impacts == pytest.approx(len(made) / 7, rel=1e-15)
    assert found.impact_speed == pytest.approx(max(speeds), rel=1e-9)
    dense = course.states(np.linspace(0.0, course.duration, 40_001))
    assert found.peak_to_peak["x"] == pytest.approx(np.ptp(dense[:, 0]), rel=1e-6)


@pytest.mark.parametrize("measures", [of_orbit, of_window])
def test_what_sticks_or_has_no_force_wears_nothing(measures) -> None:
    """A brake that holds the whole time, one of no force, and one that slips the whole time."""
    mechanism = Mechanism(
        {"block": Body(1.0), "held": Body(1.0)},
        frequency=10.0,
        pins={"belt": Pin("ground", velocity=0.7), "shaker": Pin("ground", amplitude=1e-4)},
        links={"spring": Link(("shaker", "block"), 1e3, 20.0), "weak": Link(("block", "held"), 1e-3, 1.0)},
        frictions={
            "brake": Friction(("ground", "held"), force=50.0),
            "nothing": Friction(("ground", "block"), force=0.0),
            "rub": Friction(("belt", "block"), force=2.0),
        },
        outputs={},
    )
    found = measures_of(mechanism, measures)
    assert found.peak_to_peak == {}
    assert found.wear_power == {"brake": 0.0, "nothing": 0.0, "rub": pytest.approx(2.0 * 0.7, rel=1e-9)}
