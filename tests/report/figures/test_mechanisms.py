"""The drawn mechanisms agree with the declared one, end by end."""

import numpy as np
import pytest
from matplotlib.patches import Circle, Rectangle

from derivations.mechanism import trimmer
from derivations.parts import Ground, Pin, RigidBody
from report.chapters.chapter_1 import figures as chapter_1
from report.chapters.chapter_2.figures import mechanisms


@pytest.fixture(scope="module")
def diagram():
    (axes,) = mechanisms.free_body_diagram.draw(None).axes
    return axes


def boxes(axes):
    """Name of each body with its rectangle: left, right, bottom, top."""
    found = {}
    for patch in (each for each in axes.patches if isinstance(each, Rectangle)):
        left, bottom = patch.get_xy()
        right, top = left + patch.get_width(), bottom + patch.get_height()
        middle = ((left + right) / 2, (bottom + top) / 2)
        (name,) = (
            text.get_text() for text in axes.texts if np.allclose(text.get_position(), middle, atol=1e-9)
        )
        found[name] = (left, right, bottom, top)
    return found


def thing_at(axes, x, y):
    """Name what a spring's or damper's end touches."""
    for name, (left, right, bottom, top) in boxes(axes).items():
        if bottom <= y <= top and (np.isclose(x, left) or np.isclose(x, right)):
            return name
    for bar in axes.lines:
        xs, ys = np.asarray(bar.get_xdata()), np.asarray(bar.get_ydata())
        if len(xs) == 2 and np.allclose(xs, x) and ys.min() <= y <= ys.max():
            return "pin" if bar.get_linewidth() > 2 else "surroundings"
    return None


def ends_of(axes, name):
    """Name what the lines of a spring or damper end at."""
    lines = [line for line in axes.lines if line.get_label() == name]
    places = {(x, line.get_ydata()[0]) for line in lines for x in (line.get_xdata()[0], line.get_xdata()[-1])}
    first, *_, last = sorted(places)
    return {thing_at(axes, *first), thing_at(axes, *last)}


def declared(end):
    match end:
        case Ground():
            return "surroundings"
        case Pin():
            return "pin"
        case RigidBody():
            return f"${end.mass}$"


@pytest.mark.parametrize("spring", trimmer().springs, ids=lambda spring: str(spring.stiffness))
def test_springs_join_what_the_mechanism_declares(diagram, spring):
    assert ends_of(diagram, f"${spring.stiffness}$") == {declared(spring.start), declared(spring.end)}


@pytest.mark.parametrize("damper", trimmer().dampers, ids=lambda damper: str(damper.damping))
def test_dampers_join_what_the_mechanism_declares(diagram, damper):
    assert ends_of(diagram, f"${damper.damping}$") == {declared(damper.start), declared(damper.end)}


def test_every_body_has_its_displacement(diagram):
    texts = {text.get_text() for text in diagram.texts}
    assert {f"${body.mass}$" for body in trimmer().bodies} <= texts
    assert {f"$q_{number}$" for number in range(1, 5)} | {"$u(t)$"} <= texts


def test_pin_stands_at_the_place_that_the_sine_marks():
    shaft, motion = mechanisms.eccentric_pin.draw(None).axes
    (pin,) = (patch for patch in shaft.patches if isinstance(patch, Circle))
    (marked,) = (line for line in motion.lines if line.get_marker() == "o")
    turns, displaced = marked.get_xdata()[0], marked.get_ydata()[0]
    assert np.hypot(*pin.center) == pytest.approx(1)
    assert pin.center[0] == pytest.approx(displaced)
    assert displaced == pytest.approx(np.sin(2 * np.pi * turns))


def test_bridge_touches_the_pin_with_both_edges():
    shaft, _ = mechanisms.eccentric_pin.draw(None).axes
    (pin,) = (patch for patch in shaft.patches if isinstance(patch, Circle))
    edges = sorted(line.get_xdata()[0] for line in shaft.lines if line.get_linewidth() == 2.0)
    assert edges == pytest.approx([pin.center[0] - pin.radius, pin.center[0] + pin.radius])


def test_parts_named_by_the_text_are_all_drawn():
    (axes,) = chapter_1.components.draw(None).axes
    words = " ".join(text.get_text() for text in axes.texts).replace("\n", " ")
    for part in ("motor", "shell", "eccentric pin", "driving bridge", "cutter", "guard housing", "play"):
        assert part in words


def test_play_is_the_same_on_both_sides_of_the_motor_s_pin():
    (axes,) = mechanisms.motor_and_load.draw(None).axes
    spans = [text for text in axes.texts if getattr(text, "arrow_patch", None) and text.xyann[0] > 2]
    left, right = sorted(sorted((span.xyann[0], span.xy[0])) for span in spans if span.xy[1] == 1.0)
    assert left[1] - left[0] == pytest.approx(right[1] - right[0])
