"""Pictures of mechanisms: curves are the exact motion, strips its contact and stick, marks its stability."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

import trimmer
from tests.quick import quick
from tests.trimmer import results
from tests.trimmer.drawing.pictures import (
    FIGURES,
    doubled,
    legend,
    lines,
    new_axes,
    points,
    rubbing,
    samples,
    two_masses,
)
from tests.trimmer.maps.machines import impact_oscillator
from trimmer.design.targets import Measure
from trimmer.drawing.mechanisms.branch import branch_figure
from trimmer.drawing.mechanisms.response import motion_figure, response_figure
from trimmer.drawing.mechanisms.scatter import sample_figure
from trimmer.mechanism import Body, Force, Link, Mechanism, Output

FOLD = 8.566394 / (2 * np.pi)
"""Published of pyHarm's example, see ``machines.impact_oscillator``; Hz."""


def strip(axes: Axes, name: str) -> PolyCollection:
    (found,) = (each for each in axes.collections if each.get_label() == f"_{name}")
    return found


def bars(axes: Axes, name: str) -> np.ndarray:
    """Begin and end of the bars of a strip, s, (n, 2)."""
    corners = [path.vertices[:, 0] for path in strip(axes, name).get_paths()]
    return np.array([(each.min(), each.max()) for each in corners]).reshape(-1, 2)


@pytest.fixture(scope="module")
def chaotic() -> trimmer.Response:
    play = trimmer.Mechanism.from_toml("examples/thesis-play.toml")
    loose = play.with_value("frictions.blade.force", 0.0).with_value("plays.bridge.gap", 2e-4)
    return trimmer.respond(loose, most_periods=64)


def test_the_motion_of_a_loop_is_drawn_as_it_is() -> None:
    motion = results.driven()
    axes = motion.plot(new_axes())
    output, pin, bridge = (each for each in axes.lines if each.get_label() in legend(axes))
    np.testing.assert_array_equal(output.get_ydata(), motion.output(output.get_xdata()))
    np.testing.assert_array_equal(pin.get_ydata(), motion.element_input(pin.get_xdata()))
    np.testing.assert_array_equal(bridge.get_ydata(), motion.element_output(bridge.get_xdata()))
    assert {event.time for event in motion.events} <= set(output.get_xdata())


def test_contact_and_stick_of_a_loop_are_marked_from_event_to_event() -> None:
    motion = results.driven()
    axes = motion.plot(new_axes())
    for name, begun in (("backlash, contact", "impact"), ("friction q2-q4, stick", "stick")):
        marked, component = bars(axes, name), name.split(",")[0]
        starts = [e.time for e in motion.events if e.component == component and e.kind.value == begun]
        inside = marked[:, 0] > 0
        np.testing.assert_allclose(marked[inside, 0], starts, atol=1e-12)
        # While it sticks or is in contact nothing else happens to it.
        for begin, end in marked:
            others = [e.time for e in motion.events if e.component == component and begin < e.time < end]
            assert others == pytest.approx([begin] * len(others))
        assert bool(strip(axes, name).get_hatch()) == name.endswith("stick")


@pytest.mark.parametrize(
    ("element", "names", "strips"),
    [
        (results.PLAY, ["output q2-q4", "output of the play"], ["backlash, contact"]),
        (trimmer.Relay(1e-4), ["output q2-q4"], ["relay, stick"]),
        (trimmer.Saturation(1e-4), ["output q2-q4"], []),
    ],
    ids=repr,
)
def test_a_loop_without_drive_shows_no_input_that_is_its_output(element, names, strips) -> None:
    axes = trimmer.simulate(trimmer.ClosedLoop(results.system(), element), 0.01, impulse=1e-6).plot(
        new_axes()
    )
    assert legend(axes) == names
    assert [each.get_text() for each in axes.texts] == strips


def test_contact_of_a_mechanism_is_marked_once_and_as_long_as_it_lasts() -> None:
    response = trimmer.respond(impact_oscillator(), state={"mass": (-25.0, 0.0)})
    marked = bars(response.plot(new_axes()), "wall, contact")
    share = response.motion.orbit.measures.contacts["wall"].share
    assert np.diff(marked).sum() / response.motion.orbit.period == pytest.approx(share, rel=1e-6)
    assert 0 < share < 1
    assert (np.diff(marked.ravel()) > 0).all()


def test_many_strips_stand_in_order_under_the_curves() -> None:
    shaver = trimmer.Mechanism.from_toml("examples/foil-shaver.toml")
    axes = trimmer.simulate(shaver, 0.02).plot(new_axes())
    ends = [each.get_paths()[0].vertices[:, 1] for each in axes.collections if each.get_paths()]
    (border,) = (each for each in axes.lines if each.get_transform() == axes.transAxes)
    lowest = min(line.get_ydata().min() for line in axes.lines if line is not border)
    low, high = axes.get_ylim()
    assert max(each.max() for each in ends) < border.get_ydata()[0] < (lowest - low) / (high - low) < 0.6
    middles = [text.xy[1] for text in axes.texts]
    assert (np.diff(middles) > 0).all()  # from the lowest on
    parts = [*shaver.plays, *shaver.frictions]
    assert [text.get_text().partition(",")[0] for text in axes.texts] == parts[::-1]
    assert axes.get_xlim() == (0.0, 0.02)


def test_the_outputs_of_a_mechanism_are_drawn_or_else_its_bodies() -> None:
    motion = results.stopped()
    times, values = points(motion.plot(new_axes()), "x").T
    np.testing.assert_allclose(values, motion.output("x", times), rtol=1e-12)
    bare = replace(motion.mechanism, outputs={})
    axes = trimmer.simulate(bare, 6.0, state={"mass": (12.0, 100.0)}).plot(new_axes())
    np.testing.assert_allclose(points(axes, "mass")[:, 1], values, rtol=1e-12)


def test_the_phase_plane_of_an_orbit_begins_at_the_start_of_a_period() -> None:
    orbit = results.forced()
    curve, start = orbit.plot(new_axes()).lines
    np.testing.assert_allclose(start.get_xydata(), [orbit.instant.state], rtol=1e-12)
    np.testing.assert_allclose(curve.get_xydata()[0], orbit.instant.state, rtol=1e-12)
    np.testing.assert_allclose(curve.get_xydata()[-1], orbit.instant.state, rtol=1e-6)
    assert np.ptp(curve.get_xdata()) == pytest.approx(orbit.measures.outputs["x"].peak_to_peak, rel=1e-5)


def test_the_section_of_an_orbit_is_in_the_frame_of_its_phase_plane() -> None:
    _, plane, section = response_figure(two_masses()).axes
    (point,) = section.lines
    wanted = two_masses().motion.orbit.strobed
    assert np.isclose(point.get_xydata()[:, 0], wanted[:, 0], rtol=1e-9).all()
    np.testing.assert_allclose(point.get_xydata(), plane.lines[1].get_xydata(), rtol=1e-9)
    assert (section.get_xlim(), section.get_ylim()) == (plane.get_xlim(), plane.get_ylim())


@pytest.mark.slow
def test_some_periods_are_shown_of_what_does_not_repeat(chaotic: trimmer.Response) -> None:
    assert chaotic.motion.kind is trimmer.MotionKind.CHAOTIC
    motion, plane, section = response_figure(chaotic).axes
    assert motion.get_xlim() == pytest.approx((0.0, 8 / 110))
    assert len(points(plane, "start of a drive period")) == 8
    (dots,) = section.lines
    assert len(dots.get_xdata()) == len(chaotic.motion.window.states) > 50
    assert dots.get_marker() == "."
    assert section.get_legend() is None
    assert section.get_xlim() != plane.get_xlim()


def test_each_motion_is_in_the_section_with_its_share() -> None:
    """The wall's oscillator has two motions at 7.5 rad/s."""
    response = trimmer.respond(impact_oscillator(), starts=12)
    section = response_figure(response).axes[2]
    assert len(response.motions) == 2
    assert [each.get_marker() for each in section.lines] == ["o", "s"]
    for number, (line, motion) in enumerate(zip(section.lines, response.motions, strict=True), start=1):
        np.testing.assert_allclose(line.get_xydata(), motion.orbit.strobed, rtol=1e-9)
        assert line.get_label() == f"{number}: {motion.share:.0%} of the starts"
    assert len(legend(section)) == 2


def test_what_moves_by_itself_has_no_starts_of_periods() -> None:
    thrown = trimmer.Mechanism.from_toml("examples/thrown-body.toml")
    motion, plane = motion_figure(trimmer.simulate(thrown, 0.5)).axes
    assert motion.get_xlim() == (0.0, 0.5)
    assert len(plane.lines) == 1 and plane.get_legend() is None


@pytest.mark.parametrize("make", quick([results.branch, doubled], 1))
def test_a_branch_is_drawn_with_its_stability(make) -> None:
    whole = make()
    axes = whole.plot(new_axes())
    for branch in whole.all():
        name = next(iter(branch.points[0].outputs))
        places = np.array([(point.value, point.outputs[name].peak_to_peak) for point in branch.points])
        stable = np.array([point.stable for point in branch.points])
        for word, style, wanted in (("stable", "-", stable), ("unstable", "--", ~stable)):
            found = lines(axes, f"{word}, period {branch.periods}")
            drawn = {tuple(place) for line in found for place in line.get_xydata()}
            assert {tuple(place) for place in places[wanted]} <= drawn
            assert len(drawn) <= wanted.sum() + len(found)  # each begins at the end of the one before
            assert {line.get_linestyle() for line in found} == {style}
    colours = {line.get_color() for line in axes.lines if line.get_label() in legend(axes)[:2]}
    assert len(colours) == 1


def test_a_branch_of_one_point_is_seen() -> None:
    branch = replace(rubbing(), points=rubbing().points[:1])
    assert [line.get_marker() for line in branch.plot(new_axes()).lines] == ["."]


def test_special_points_are_marked_and_named() -> None:
    branch = results.branch()
    (fold,) = lines(branch.plot(new_axes()), "fold")
    assert fold.get_xdata() == pytest.approx(FOLD, rel=1e-5)
    of_all_kinds = replace(
        branch, special=tuple(replace(branch.special[0], kind=k) for k in trimmer.SpecialKind)
    )
    axes = of_all_kinds.plot(new_axes())
    marks = [lines(axes, kind.word)[0].get_marker() for kind in trimmer.SpecialKind]
    assert len(set(marks)) == len(trimmer.SpecialKind)
    assert set(legend(axes)) >= {kind.word for kind in trimmer.SpecialKind}


def test_each_output_has_a_panel_and_one_that_is_not_there_is_refused() -> None:
    branch = results.branch()
    mechanism = branch.map.mechanism
    two = replace(mechanism, outputs={**mechanism.outputs, "half": Output({"mass": 0.5})})
    settings = trimmer.FollowSettings(quiet=True, most_points=3)
    followed = trimmer.follow(two, "frequency", 1.25, 1.3, settings=settings)
    whole, half = branch_figure(followed).axes
    np.testing.assert_allclose(half.lines[0].get_ydata(), whole.lines[0].get_ydata() / 2)
    assert half.get_ylabel() == "half, peak to peak, m"
    assert points(followed.plot(new_axes(), "half"), "stable, period 1").shape == (3, 2)
    with pytest.raises(trimmer.MechanismError, match="no output is called 'y'; there are x"):
        branch.plot(new_axes(), output="y")
    none = trimmer.follow(replace(mechanism, outputs={}), "frequency", 1.25, 1.3, settings=settings)
    with pytest.raises(trimmer.MechanismError, match="has no output"):
        none.plot(new_axes())


def test_samples_that_miss_a_target_are_hatched() -> None:
    found = samples()
    stroke = found.measured(next(each for each in found.asked if each.measure is Measure.STROKE))
    panel, *others = FIGURES["sample"]().axes
    (bound,) = {target.bound for target in found.targets}
    assert panel.lines[0].get_xdata() == [bound, bound]
    for met, wanted in ((True, stroke >= bound), (False, stroke < bound)):
        drawn = sum(each.get_height() for each in panel.patches if bool(each.get_hatch()) != met)
        assert drawn == wanted.sum() > 0
    assert all(not each.get_hatch() or each.get_height() == 0 for axes in others for each in axes.patches)


def test_samples_that_are_all_alike_are_one_bar() -> None:
    alike = replace(samples(), trials=(samples().trials[0],) * 3)
    panel = sample_figure(alike).axes[0]
    assert sorted(each.get_height() for each in panel.patches) == [0, 3]


@pytest.mark.parametrize("drive", [None, 0.2])
def test_eight_periods_are_shown_of_vibrations_that_never_meet_again(drive: float | None) -> None:
    """Two equal bodies between three equal springs, at 1 Hz and sqrt(3) Hz; without a drive of the slower."""
    stiffness = (2.0 * np.pi) ** 2
    between = {"left": ("ground", "one"), "middle": ("one", "other"), "right": ("other", "ground")}
    machine = Mechanism(
        {"one": Body(1.0), "other": Body(1.0)},
        frequency=drive,
        links={name: Link(ends, stiffness=stiffness) for name, ends in between.items()},
        forces={} if drive is None else {"push": Force("one", amplitude=1.0)},
        outputs={"x": Output({"one": 1.0})},
    )
    response = trimmer.respond(machine, state={"one": (1.0, 0.0)})
    axes = response.plot(new_axes())
    assert response.motion.linear is not None
    assert axes.get_xlim() == pytest.approx((0.0, 8.0 / (drive or 1.0)))
    if drive is None:
        times, values = points(axes, "x").T
        wave = (np.cos(2 * np.pi * times) + np.cos(2 * np.pi * np.sqrt(3) * times)) / 2
        np.testing.assert_allclose(values, wave, atol=1e-9)
