"""Pictures of mechanisms made by hand: branches, curves, motions, sections, samples."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np
import pytest
from matplotlib.colors import to_hex

from tests.trimmer.drawing.blank import grid, new_axes
from trimmer.branches.special import SpecialKind
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import Asked
from trimmer.drawing.look import COLOURS, LINES, UNSTABLE
from trimmer.drawing.mechanisms import branch as of_branch
from trimmer.drawing.mechanisms import curves, motions, response, scatter
from trimmer.drawing.mechanisms.motion_map import draw_map
from trimmer.errors import MechanismError
from trimmer.response.response import MotionKind


def made_branch(values: list[float], stable: str, periods: int = 1, others: tuple[Made, ...] = ()) -> Made:
    points = [
        Made(
            value=value,
            stable=letter == "s",
            outputs={"x": Made(peak_to_peak=10 * value), "y": Made(peak_to_peak=value)},
        )
        for value, letter in zip(values, stable, strict=True)
    ]
    mechanism = Made(outputs={"x": 1, "y": 2}, frequency=60.0, places={"frequency": "Hz"})
    made = Made(points=points, periods=periods, special=[], map=Made(mechanism=mechanism, place="frequency"))
    made.all = lambda: [made, *others]
    made.outputs_at = lambda special: {"x": Made(peak_to_peak=7.0), "y": Made(peak_to_peak=8.0)}
    return made


def test_stretches_of_a_branch_join_at_the_last_point_of_the_one_before(monkeypatch) -> None:
    monkeypatch.setattr(of_branch, "unit_of", lambda places, place: places[place])
    doubled, empty = made_branch([2.5], "u", 2), made_branch([], "", 5)
    whole = made_branch([1.0, 2.0, 3.0, 4.0], "suus", others=(doubled, empty))
    whole.special = [Made(kind=SpecialKind.TORUS, value=2.25)]
    axes = of_branch.draw_branch(whole, new_axes(), "y")
    first, second, third, special, single = axes.lines
    assert [each.get_xdata().tolist() for each in (first, second, third)] == [[1], [1, 2, 3], [3, 4]]
    assert third.get_ydata().tolist() == [3, 4]
    assert [each.get_linestyle() for each in (first, second, third)] == ["-", "--", "-"]
    assert second._unscaled_dash_pattern[1] == UNSTABLE[1]
    assert [each.get_color() for each in (first, single)] == [COLOURS[0], COLOURS[1]]
    assert [each.get_marker() for each in (first, single)] == ["", "."]
    assert (single.get_label(), single.get_xydata().tolist()) == ("unstable, period 2", [[2.5, 2.5]])
    assert special.get_xydata().tolist() == [[2.25, 8.0]]
    assert (special.get_marker(), special.get_label()) == ("P", SpecialKind.TORUS.word)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("frequency, Hz", "y, peak to peak, m")
    assert grid(axes)
    assert of_branch.draw_branch(whole, new_axes()).lines[0].get_ydata().tolist() == [10.0]


def test_a_branch_is_drawn_for_each_output(monkeypatch) -> None:
    monkeypatch.setattr(of_branch, "unit_of", lambda places, place: places[place])
    whole = made_branch([1.0, 2.0], "ss")
    figure = of_branch.branch_figure(whole)
    assert tuple(figure.get_size_inches()) == (7.2, 6.8)
    assert [axes.get_ylabel()[0] for axes in figure.axes] == ["x", "y"]
    whole.map.mechanism.outputs = {}
    with pytest.raises(MechanismError, match="has no output"):
        of_branch.branch_figure(whole)


def test_what_moves_by_itself_has_its_own_period() -> None:
    made = made_branch([1.0], "s", 4)
    assert of_branch._period(made) == "period 4"
    made.map.mechanism.frequency = None
    assert of_branch._period(made) == "period doubled to 4"
    made.periods = 1
    assert of_branch._period(made) == "own period"


def test_curves_of_one_name_have_one_look() -> None:
    axes = new_axes()
    given = [("a", [(1e-3, 2.0), (3e-3, 5.0)]), ("b", [(0.0, 1.0)]), ("a", [(2e-3, 4.0)])]
    curves.draw_curves(given, ("gap", "frequency"), ("m", "Hz"), axes)
    under, over = axes.lines[::2], axes.lines[1::2]
    assert [each.get_linestyle() for each in over] == ["-", "--", "-"]
    assert {to_hex(each.get_color()) for each in under} == {"#ffffff"}
    assert {to_hex(each.get_color()) for each in over} == {"#000000"}
    assert [each.get_xydata().tolist() for each in under] == [each.get_xydata().tolist() for each in over]
    assert over[0].get_xydata().tolist() == [[1e-3, 2.0], [3e-3, 5.0]]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a", "b"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("gap, mm", "frequency, Hz")
    assert grid(axes)
    low, high = axes.get_xlim()
    assert low < 0.0 and high > 3e-3
    limits = axes.get_xlim(), axes.get_ylim()
    curves.draw_curves([("c", [(1.0, 900.0)])], ("p", "q"), ("", ""), axes)
    assert (axes.get_xlim(), axes.get_ylim()) == limits
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a", "b", "c"]
    assert axes.get_xlabel() == "gap, mm"


def test_curves_over_what_has_no_legend() -> None:
    axes = new_axes()
    axes.plot([0.0, 1.0], [0.0, 1.0])
    curves.draw_curves([("c", [(0.5, 9.0)])], ("p", "q"), ("", ""), axes)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["c"]
    assert axes.get_ylim()[1] < 2.0


def test_impacts_are_drawn_of_what_has_no_output() -> None:
    motion = Made(kind=MotionKind.CHAOTIC, period_count=0)
    result = Made(
        cells=[Made(motions=[motion])] * 3,
        shape=(1, 3),
        places=("gap",),
        units=("m",),
        values=(np.array([1e-6, 2e-6, 4e-6]),),
        stroke=np.array([[3e-3, 2e-3, 1e-3]]),
        impacts=np.array([[1.0, 2.0, 5.0]]),
        inputs=Made(mechanism=Made(outputs={}), settings=Made(most_periods=300)),
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("trimmer.drawing.mechanisms.kinds.described", lambda motion: "chaotic")
        axes = draw_map(result, new_axes())
        result.inputs.mechanism.outputs = {"x": 1}
        other = draw_map(result, new_axes())
    (dots,) = axes.collections
    np.testing.assert_allclose(dots.get_offsets(), np.transpose([result.values[0], [1.0, 2.0, 5.0]]))
    assert to_hex(dots.get_facecolor()[0]) == "#222222"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("gap, µm", "impacts per drive period")
    np.testing.assert_allclose(other.collections[0].get_offsets()[:, 1], [3e-3, 2e-3, 1e-3])
    assert other.get_ylabel() == "x, peak to peak, mm"
    assert grid(axes)


class MadeFlow:
    """A body that moves as x = 5 - t within two periods of 2 s; the state ends with what drives it."""

    period = 2.0

    def __init__(self, outputs: bool = True) -> None:
        layout = Made(bodies=["mass"], size=3, contacts=["wall"], frictions=["blade"])
        layout.forcing_at = lambda time: np.array([time + 1.0])
        base = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
        self.modes = Made(layout=layout, machine=Made(base=base))
        self.mechanism = Made(outputs={"x": 1} if outputs else {})


COURSE = Made(
    duration=4.0, states=lambda times: np.transpose([5.0 - times, 0.0 * times - 1.0, 0.0 * times + 1.0])
)


@pytest.fixture
def without_output(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(motions, "output_rows", lambda mechanism, layout: {})
    monkeypatch.setattr(motions, "strips_of", lambda flow, course: [])


def test_bodies_are_drawn_of_what_has_no_output(without_output) -> None:
    axes = motions.draw_motion(MadeFlow(), COURSE, new_axes())
    (curve,) = axes.lines
    times = np.linspace(0.0, 4.0, 4000)
    np.testing.assert_allclose(curve.get_xydata().T, [times, 5.0 - times])
    assert (curve.get_label(), curve.get_color()) == ("mass", LINES[0]["color"])
    assert axes.get_xlim() == (0.0, 4.0)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time, s", "displacement, m")
    assert grid(axes)


def test_dots_are_at_the_starts_of_drive_periods(without_output) -> None:
    flow = MadeFlow()
    axes = motions.draw_phase_plane(flow, COURSE, new_axes())
    curve, dots = axes.lines
    assert dots.get_xydata().tolist() == [[5.0, -1.0], [3.0, -1.0]]  # the end starts none
    assert (curve.get_xydata()[0].tolist(), curve.get_xydata()[-1].tolist()) == ([5.0, -1.0], [1.0, -1.0])
    assert (to_hex(curve.get_color()), to_hex(dots.get_color())) == (COLOURS[0], "#000000")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("mass, m", "rate of mass, m/s")
    assert grid(axes)
    assert len(axes.xaxis.get_major_locator().tick_values(1.0, 5.0)) <= 6
    flow.period = 0.0
    assert len(motions.draw_phase_plane(flow, COURSE, new_axes()).lines) == 1


@pytest.mark.parametrize(
    ("count", "number", "mark"), [(49, 0, "o"), (49, 2, "D"), (49, 6, "s"), (50, 2, ".")]
)
def test_points_of_a_section_are_marked_by_their_number(
    without_output, count: int, number: int, mark: str
) -> None:
    states = np.tile([3.0, -7.0], (count, 1))
    axes = new_axes()
    motions.draw_section(axes, MadeFlow(), states, "label", number)
    (points,) = axes.lines
    assert points.get_xydata().tolist() == [[3.0, -7.0]] * count
    assert (points.get_marker(), points.get_color()) == (mark, LINES[number % 6]["color"])
    assert points.get_markersize() == (4.0 if count < 50 else 1.5)
    assert (axes.get_xlabel(), points.get_label()) == ("mass, m", "label")


def test_strips_of_a_mechanism_are_of_its_contacts_and_frictions(monkeypatch) -> None:
    asked = []

    def status(course: object, part: int, on: tuple[int, ...]) -> np.ndarray:
        asked.append((part, on))
        return np.array([part == 0, part == 1])

    monkeypatch.setattr(motions, "while_status", status)
    course = Made(log=Made(start=np.array([0.0, 1.5])), duration=4.0)
    first, second = motions.strips_of(MadeFlow(), course)
    assert (first.name, first.bars, first.stick) == ("wall, contact", [(0.0, 1.5)], False)
    assert (second.name, second.bars, second.stick) == ("blade, stick", [(1.5, 2.5)], True)
    assert asked == [(0, motions.PUSHING), (1, (motions.STICK,))]


def test_a_section_that_is_nearly_a_point_has_the_frame_of_the_phase_plane() -> None:
    for size, same in ((0.049, True), (0.051, False)):
        section, plane = new_axes(), new_axes()
        plane.set(xlim=(0.0, 1.0), ylim=(-5.0, 5.0), xlabel="x, mm")
        section.plot([0.5, 0.5 + size], [0.0, 0.1])
        response._frame(section, plane)
        assert (section.get_xlim() == (0.0, 1.0)) == same
        assert (section.get_ylim() == (-5.0, 5.0)) == same
        assert section.get_xlabel() == ("x, mm" if same else "")
        own = plane.xaxis.get_major_formatter()
        assert (section.xaxis.get_major_formatter() is own) == same
    section, plane = new_axes(), new_axes()
    plane.set(xlim=(1.0, 0.0), ylim=(-5.0, 5.0))
    section.plot([0.5, 0.51], [0.0, 0.1])
    response._frame(section, plane)
    assert section.get_xlim() == (1.0, 0.0)  # whichever way the axis runs


def test_a_simulated_motion_is_drawn_over_its_phase_plane(without_output) -> None:
    motion = Made(flow=MadeFlow(), course=COURSE, mechanism=Made(title="title"))
    figure = response.motion_figure(motion)
    above, below = figure.axes
    assert (tuple(figure.get_size_inches()), figure.get_suptitle()) == ((7.6, 7.2), "title")
    assert above.get_gridspec().get_height_ratios() == [4, 5]
    assert (above.get_xlabel(), below.get_xlabel()) == ("time, s", "mass, m")
    assert below.get_legend() is not None


def test_some_periods_are_shown_of_what_does_not_repeat() -> None:
    orbit_of = Made(flow="flow", course="course")
    assert response.shown(Made(orbit=orbit_of, window=None)) == ("flow", "course")
    flow = Made(course=lambda end, periods: (end, periods))
    lost = Made(orbit=None, rest=None, linear=None, window=None)
    seen = Made(**{**vars(lost), "window": Made(flow=flow, end="end")})
    assert response.shown(seen) == (flow, ("end", 8))
    resting = Made(**{**vars(lost), "rest": orbit_of})
    assert response.shown(resting) == ("flow", "course")
    with pytest.raises(ValueError, match="nothing was found"):
        response.shown(lost)


def test_each_motion_is_in_the_section(monkeypatch, without_output) -> None:
    flow = MadeFlow()
    strobed, many = np.array([[3.0, -7.0]]), np.array([[1.0, 2.0], [2.0, 1.0]])
    repeats = Made(orbit=Made(flow=flow, course=COURSE, strobed=strobed), window=None, share=0.75)
    window = Made(flow=flow, states=many)
    restless = Made(orbit=None, window=window, share=0.25)
    lost = Made(orbit=None, window=None, share=0.0)
    made = Made(motion=repeats, motions=[repeats, restless, lost], mechanism=Made(title="title"))
    figure = response.response_figure(made)
    above, plane, section = figure.axes
    assert tuple(figure.get_size_inches()) == (7.6, 7.2)
    assert figure.get_suptitle() == "title"
    first, second = section.lines
    assert (first.get_xydata().tolist(), second.get_xydata().tolist()) == (strobed.tolist(), many.tolist())
    assert (first.get_label(), second.get_label()) == ("1: 75% of the starts", "2: 25% of the starts")
    assert section.get_legend() is not None
    assert above.get_xlim() == (0.0, 4.0)
    assert plane.get_title() and section.get_title()
    made.motions = [repeats]
    assert response.response_figure(made).axes[2].get_legend() is None


def made_samples(values: list[float]) -> tuple[Made, Asked]:
    asked = Asked(Measure.STROKE, "x")
    targets = [
        Target("stroke_at_least", Measure.STROKE, "x", 2e-3),
        Target("stroke_at_least", Measure.STROKE, "y", 9.0),
        Target("impact_speed_at_most", Measure.IMPACT_SPEED, "x", 9.0),
    ]
    other = Asked(Measure.IMPACT_SPEED, "wall")
    samples = Made(
        asked=[asked, Asked(Measure.PERIOD, ""), other, other],
        targets=targets,
        measured=lambda each: np.array(values) * (1 if each == asked else 2),
    )
    return samples, asked


def test_samples_that_miss_a_target_are_hatched() -> None:
    samples, asked = made_samples([1e-3, 2e-3, 3e-3, 3.5e-3, np.nan])
    axes = scatter.draw_distribution(samples, asked, new_axes())
    hatched = [each for each in axes.patches if each.get_hatch()]
    plain = [each for each in axes.patches if not each.get_hatch()]
    assert sum(each.get_height() for each in plain) == 3
    assert sum(each.get_height() for each in hatched) == 1
    assert {to_hex(each.get_facecolor()) for each in plain} == {"#0072b2"}
    assert {to_hex(each.get_facecolor()) for each in hatched} == {"#d55e00"}
    (bound,) = axes.lines
    assert bound.get_xdata() == [2e-3, 2e-3]
    assert axes.get_xlabel().endswith(", mm") and axes.get_ylabel() == "samples"
    samples, asked = made_samples([2e-3, 2e-3])
    same = scatter.draw_distribution(samples, asked, new_axes())
    assert {each.get_height() for each in same.patches} == {0.0, 2.0}
    assert len(same.patches) == 2


def test_samples_have_a_panel_for_each_measure() -> None:
    samples, _ = made_samples([1e-3, 2e-3, 3e-3])
    figure = scatter.sample_figure(samples)
    assert tuple(figure.get_size_inches()) == pytest.approx((7.2, 4.2))
    assert [axes.axison for axes in figure.axes] == [True, True, True, False]
    assert figure.axes[1].get_xlabel().startswith("impact speed of wall")
    samples.asked = samples.asked[:1]
    assert tuple(scatter.sample_figure(samples).get_size_inches()) == pytest.approx((7.2, 2.1))
