"""The drawn characteristics are those of mechanics, with areas that are the work in a period."""

import numpy as np
import pytest

from report.chapters.chapter_2.figures import waveforms
from report.chapters.chapter_2.figures.waveforms import AMPLITUDES


def area(x, y):
    """Area that a closed path runs round, positive if counter-clockwise."""
    return float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2


@pytest.fixture(scope="module")
def backlash():
    (axes,) = waveforms.backlash_characteristic.draw(None).axes
    return axes


@pytest.mark.parametrize("amplitude", AMPLITUDES)
def test_loop_of_backlash_has_slope_one_width_two_and_runs_counter_clockwise(backlash, amplitude):
    (path,) = (each for each in backlash.lines if each.get_label() == f"$A = {amplitude:g}\\,b$")
    x, y = np.asarray(path.get_xdata()), np.asarray(path.get_ydata())
    moving = np.abs(np.diff(y)) > 1e-12
    slopes = np.diff(y)[moving] / np.diff(x)[moving]
    assert np.median(slopes) == pytest.approx(1)
    assert np.ptp(y) == pytest.approx(2 * (amplitude - 1))
    assert area(x, y) == pytest.approx(4 * (amplitude - 1), rel=1e-3)


def test_named_points_are_corners_of_the_larger_loop(backlash):
    amplitude = AMPLITUDES[1]
    places = {text.get_text(): text.xy for text in backlash.texts if hasattr(text, "xy")}
    b, c, d, e = (places[f"${letter}$"] for letter in "BCDE")
    assert b == (amplitude, amplitude - 1)
    assert b[0] - c[0] == pytest.approx(2)
    assert (c[1], e[1]) == (b[1], d[1])
    assert d == (-b[0], -b[1])
    assert e == (-c[0], -c[1])
    assert places["$A$"] == (1, 0)


def test_friction_has_the_sign_of_the_velocity_and_takes_work():
    by_velocity, by_displacement, by_time = waveforms.coulomb_friction.draw(None).axes
    lines = {each.get_label(): np.asarray(each.get_ydata()) for each in by_time.lines}
    velocity, force = lines[r"velocity$/(\omega A)$"], lines["force$/F_c$"]
    decided = np.abs(velocity) > 1e-9
    np.testing.assert_array_equal(force[decided], np.sign(velocity[decided]))
    (path,) = by_displacement.lines
    assert area(np.asarray(path.get_xdata()), np.asarray(path.get_ydata())) == pytest.approx(-4)
    for step in by_velocity.lines[:2]:
        assert step.get_ydata()[1] == np.sign(step.get_xdata()[1])
