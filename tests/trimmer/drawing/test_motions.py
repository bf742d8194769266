"""Pictures of motions: curves are the exact motion, strips mark contact and stick."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes import Axes

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.drawing.mechanisms.response import motion_figure, response_figure
from trimmer.drawing.strips import Strip, bars_of, draw_strips


def bars(axes: Axes, name: str) -> np.ndarray:
    """Begin and end of the bars of a strip, s, (n, 2)."""
    (found,) = (each for each in axes.collections if each.get_label() == f"_{name}")
    corners = [path.vertices[:, 0] for path in found.get_paths()]
    return np.array([(each.min(), each.max()) for each in corners]).reshape(-1, 2)


def test_segments_that_touch_are_one_bar() -> None:
    starts = np.array([0.0, 1.0, 2.0, 2.0, 3.5])
    assert bars_of(starts, 4.0, np.array([True, True, False, False, True])) == [(0.0, 2.0), (3.5, 0.5)]
    assert bars_of(starts, 4.0, np.zeros(5, bool)) == []


def test_strips_lie_under_the_curves() -> None:
    axes = new_axes()
    axes.plot([0, 1], [-3, 5])
    names = [f"part {number}, contact" for number in range(12)]
    draw_strips(axes, [Strip(name, [(0.2, 0.3)], number % 2 == 1) for number, name in enumerate(names)])
    share = (-3 - axes.get_ylim()[0]) / np.ptp(axes.get_ylim())
    tops = [each.get_paths()[0].vertices[:, 1].max() for each in axes.collections]
    assert max(tops) < share < 0.6
    assert tops == sorted(tops)  # from the lowest on
    assert [text.get_text() for text in axes.texts] == names[::-1]
    assert [bool(each.get_hatch()) for each in axes.collections] == [True, False] * 6


def test_the_motion_of_a_loop_is_drawn_as_it_is() -> None:
    motion = results.driven()
    axes = motion.plot(new_axes())
    output, pin, bridge = (each for each in axes.lines if not each.get_label().startswith("_"))
    np.testing.assert_array_equal(output.get_ydata(), motion.output(output.get_xdata()))
    np.testing.assert_array_equal(pin.get_ydata(), motion.element_input(pin.get_xdata()))
    np.testing.assert_array_equal(bridge.get_ydata(), motion.element_output(bridge.get_xdata()))
    assert axes.get_xlim() == (0.0, motion.duration)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time, ms", "displacement, mm")


def test_contact_and_stick_of_a_loop_are_marked_from_event_to_event() -> None:
    motion = results.driven()
    axes = motion.plot(new_axes())
    for name, begun in (("backlash, contact", "impact"), ("friction q2-q4, stick", "stick")):
        marked = bars(axes, name)
        (component,) = {name.split(",")[0]}
        starts = [e.time for e in motion.events if e.component == component and e.kind.value == begun]
        inside = marked[:, 0] > 0
        np.testing.assert_allclose(marked[inside, 0], starts, atol=1e-12)
        # While it sticks or is in contact nothing else happens to it.
        for begin, end in marked:
            others = [e.time for e in motion.events if e.component == component and begin < e.time < end]
            assert others == pytest.approx([begin] * len(others))


def test_a_loop_without_drive_shows_no_input_that_is_its_output() -> None:
    axes = trimmer.simulate(results.loop(), 0.01, impulse=1e-6).plot(new_axes())
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels == ["output q2-q4", "output of the play"]


def test_contact_of_a_mechanism_is_marked_as_long_as_it_lasts() -> None:
    orbit = results.forced()
    axes = trimmer.drawing.mechanisms.motions.draw_motion(orbit.flow, orbit.course, new_axes())
    marked = bars(axes, "wall, contact")
    share = orbit.measures.contacts["wall"].share
    assert np.diff(marked).sum() / orbit.period == pytest.approx(share, rel=1e-6)
    assert 0 < share < 1


def test_the_outputs_of_a_mechanism_are_drawn() -> None:
    motion = results.stopped()
    (curve,) = (each for each in motion.plot(new_axes()).lines if each.get_label() == "x")
    np.testing.assert_allclose(curve.get_ydata(), motion.output("x", curve.get_xdata()), rtol=1e-12)


def test_the_phase_plane_of_an_orbit_begins_at_the_start_of_a_period() -> None:
    orbit = results.forced()
    axes = orbit.plot(new_axes())
    curve, start = axes.lines
    np.testing.assert_allclose(start.get_xydata()[0], orbit.instant.state, rtol=1e-12)
    np.testing.assert_allclose(curve.get_xydata()[0], orbit.instant.state, rtol=1e-12)
    np.testing.assert_allclose(curve.get_xydata()[-1], orbit.instant.state, rtol=1e-6)
    assert np.ptp(curve.get_xdata()) == pytest.approx(orbit.measures.outputs["x"].peak_to_peak, rel=1e-5)


def test_the_picture_of_a_response_has_three_panels() -> None:
    figure = response_figure(results.response())
    motion, plane, section = figure.axes
    assert figure.get_suptitle() == "Impact oscillator"
    assert motion.get_xlabel().startswith("time")
    (point,) = section.lines
    np.testing.assert_allclose(point.get_xydata(), results.response().motion.orbit.strobed, rtol=1e-9)
    assert section.get_xlim() == plane.get_xlim()


def test_the_picture_of_a_motion_has_two_panels() -> None:
    assert len(motion_figure(results.stopped()).axes) == 2
