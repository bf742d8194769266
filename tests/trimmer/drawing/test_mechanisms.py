"""Pictures of mechanisms: curves are the exact motion, strips its contact and stick, marks its stability."""

from dataclasses import replace

import numpy as np
import pytest

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.pictures import legend, lines, new_axes, points, rubbing, samples
from trimmer.drawing.mechanisms.branch import branch_figure
from trimmer.drawing.mechanisms.response import response_figure
from trimmer.drawing.mechanisms.scatter import sample_figure
from trimmer.mechanism import Body, Force, Link, Mechanism, Output

FOLD = 8.566394 / (2 * np.pi)  # Published of pyHarm's example, see ``machines.impact_oscillator``; Hz


@pytest.fixture(scope="module")
def chaotic() -> trimmer.Response:
    play = trimmer.Mechanism.from_toml("examples/thesis-play.toml")
    loose = play.with_value("frictions.blade.force", 0.0).with_value("plays.bridge.gap", 2e-4)
    return trimmer.respond(loose, most_periods=64)


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
    with pytest.raises(trimmer.MechanismError, match="no output is called 'y'; there is x"):
        branch.plot(new_axes(), output="y")
    none = trimmer.follow(replace(mechanism, outputs={}), "frequency", 1.25, 1.3, settings=settings)
    with pytest.raises(trimmer.MechanismError, match="has no output"):
        none.plot(new_axes())


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
