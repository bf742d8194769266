"""Pictures of motions and orbits of loops made by hand."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np

from tests.trimmer.drawing.blank import grid, new_axes
from trimmer.drawing import loop_motion, orbit
from trimmer.drawing.look import COLOURS, LINES
from trimmer.motion.relay_component import HELD


def made_motion() -> Made:
    modes = Made(system=Made(labels=["play", "law", "relay"], drive=None))
    play = object.__new__(loop_motion.BacklashComponent)
    held = Made(mode_names=["plus", "minus", "other", "more"])
    held.mode_names[HELD] = "held"
    modes.system.components = [play, Made(mode_names=["one"]), held]
    modes.component_modes = lambda number: [(0, 0, HELD), (1, 0, 0), (2, 0, HELD)][number]
    model = Made(output_labels=["q2"])
    return Made(
        loop=Made(modes=modes, model=model),
        log=Made(start=np.array([0.0, 1.0, 3.0]), mode=np.array([0, 1, 2])),
        duration=4.0,
        output=lambda times: times,
        element_input=lambda times: 2.0 * times,
        element_output=lambda times: 3.0 * times,
    )


def test_strips_of_a_loop_are_of_its_plays_and_of_what_can_be_held(monkeypatch) -> None:
    names = property(lambda self: ("upper contact", "free", "lower contact"))
    monkeypatch.setattr(loop_motion.BacklashComponent, "mode_names", names, raising=False)
    contact, stick = loop_motion.strips_of(made_motion())
    assert (contact.name, contact.bars, contact.stick) == ("play, contact", [(0.0, 1.0), (3.0, 1.0)], False)
    assert (stick.name, stick.bars, stick.stick) == ("relay, stick", [(0.0, 1.0), (3.0, 1.0)], True)


def test_signals_of_a_loop_are_drawn_at_its_events_too(monkeypatch) -> None:
    monkeypatch.setattr(loop_motion, "strips_of", lambda motion: [])
    motion = made_motion()
    motion.log.start = np.array([0.0, 1.00001, 5.0])
    axes = loop_motion.draw_loop_motion(motion, new_axes())
    output, bridge = axes.lines
    assert (output.get_label(), bridge.get_label()) == ("output q2", "output of the play")
    np.testing.assert_array_equal(bridge.get_ydata(), 3.0 * bridge.get_xdata())
    assert len(axes.get_legend().get_texts()) == 2
    assert output.get_xdata().size == 4001
    assert 1.00001 in output.get_xdata()
    assert [each.get_color() for each in axes.lines] == [each["color"] for each in LINES[:2]]
    motion.log.start = np.linspace(0.0, 4.0, 2001)
    assert loop_motion.draw_loop_motion(motion, new_axes()).lines[0].get_xdata().size == 4000
    motion.loop.modes.system.drive = 1
    labels = [each.get_label() for each in loop_motion.draw_loop_motion(motion, new_axes()).lines]
    assert labels == ["output q2", "input of the play", "output of the play"]
    motion.loop.modes.system.components = [Made()]
    assert list(loop_motion.signals_of(motion, np.zeros(1))) == ["output q2"]
    assert grid(axes)


def test_orbits_are_drawn_with_their_events() -> None:
    def made(stable: bool) -> Made:
        motion = Made(values=lambda times, rows: np.array([times, -2.0 * times]))
        return Made(
            motion=motion,
            period=4.0,
            switching_times=np.array([1.00001, 4.5]),
            stable=stable,
            steadiness="stable" if stable else "not stable",
            frequency=0.25,
            amplitude=2e-5,
        )

    axes = orbit.draw_orbits([made(True), made(False)], new_axes())
    first, dots, second, _ = axes.lines
    assert (first.get_linestyle(), second.get_linestyle()) == ("-", "--")
    assert [each.get_color() for each in (first, second)] == list(COLOURS[:2])
    assert first.get_xdata().size == 2001
    assert (first.get_xdata()[0], first.get_xdata()[-1]) == (0.0, 4.0)
    assert dots.get_xydata().tolist() == [[1.00001, -2.00002]]
    assert first.get_label() == "stable: 0.25 Hz,\nA = 20 µm"
    assert second.get_label().startswith("not stable")
    assert len(axes.get_legend().get_texts()) == 3
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("input of the element, m", "its rate, m/s")
    assert grid(axes)
