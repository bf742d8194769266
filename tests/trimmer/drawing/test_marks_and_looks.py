"""What all pictures share: looks of lines, marks, arrows, legends, strips, files of pictures."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.image import imread
from matplotlib.text import Text

from tests.trimmer.drawing.blank import new_axes
from trimmer.drawing import look
from trimmer.drawing.along import Along, plot_along
from trimmer.drawing.axes import add_legend, axes_for
from trimmer.drawing.content import content_of, figure_of, head, new_figure
from trimmer.drawing.marks import arrow, as_pair, critical_point, limit_cycle
from trimmer.drawing.strips import Strip, bars_of, draw_strips
from trimmer.drawing.units import name_axis, prefix_for, with_prefix


def test_lines_are_told_apart_by_their_dashes() -> None:
    # On and off in line widths; the colours are those of Okabe and Ito (2008).
    dashes = [(), (6, 2), (6, 2, 1.5, 2), (1.5, 1.5), (9, 2, 1.5, 2, 1.5, 2), (3, 1.5)]
    styles = [each["linestyle"] for each in look.LINES]
    assert styles == ["solid", *((0, each) for each in dashes[1:])]
    assert look.UNSTABLE == (0, (4, 2))
    assert (look.DOTTED["linewidth"], look.FAINT["linewidth"]) == (0.9, 1.0)
    assert look.COLOURS == ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00")
    assert [look.colour(number) for number in (0, 4, 5, 11)] == [look.COLOURS[at] for at in (0, 4, 0, 1)]
    assert [look.line(number) for number in (0, 5, 6)] == [look.LINES[at] for at in (0, 5, 0)]


def test_a_curve_that_is_read_is_shown_whole() -> None:
    axes = new_axes()
    plot_along(axes, np.array([2 + 30j, 5 + 70j]), Along("ω", "rad/s", np.array([1.0, 2.0])))
    (low, high), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    assert axes.lines[0].along.quantity == "ω"
    assert 1.5 < low < 2.0 and 5.0 < high < 5.5
    assert 25.0 < bottom < 30.0 and 70.0 < top < 75.0


def test_marks_are_where_they_are_said_to_be() -> None:
    axes = new_axes()
    limit_cycle(axes, 3 - 4j, stable=True)
    limit_cycle(axes, (5.0, 6.0), stable=False, label="name")
    limit_cycle(axes, (7.0, 8.0), stable=False)
    critical_point(axes)
    places = [tuple(np.ravel(each.get_data())) for each in axes.lines]
    assert places == [(3.0, -4.0), (5.0, 6.0), (7.0, 8.0), (-1.0, 0.0)]
    labels = [each.get_label() for each in axes.lines]
    assert labels[:3] == ["_stable limit cycle", "name", "_unstable limit cycle"]
    assert [to_hex(each.get_markerfacecolor()) for each in axes.lines[:3]] == ["#000000"] + 2 * ["#ffffff"]
    assert as_pair(1 - 2j) == (1, -2)


def test_an_arrow_ends_where_it_points() -> None:
    axes = new_axes()
    arrow(axes, (1.0, 2.0), 3 + 4j, color="red")
    (drawn,) = axes.texts
    assert (drawn.xy, drawn.xyann) == ((3, 4), (1, 2))
    assert to_hex(drawn.arrow_patch.get_facecolor()) == "#ff0000"
    assert drawn.arrow_patch.get_mutation_scale() == 11


def anchored(axes: Axes) -> np.ndarray:
    """Where the upper left corner of a legend stands, as shares of the axes."""
    legend = axes.get_legend()
    assert legend._loc == 2
    assert legend.borderaxespad == 0.0
    return np.asarray(axes.transAxes.inverted().transform(legend.get_bbox_to_anchor().p0))


@pytest.mark.parametrize(("width", "beside"), [(4.0, True), (3.99, False)])
def test_a_legend_stands_beside_axes_from_four_inches_on(width: float, beside: bool) -> None:
    figure = Figure(figsize=(2 * width, 10.0))
    axes = figure.add_axes((0.25, 0.5, 0.5, 0.25))
    axes.plot([1, 2], label="a")
    add_legend(axes, title="of all")
    assert axes.get_legend().get_title().get_text() == "of all"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a"]
    under = -3.6 * 10.0 / 72 / 2.5  # font size in inches, over the height of the axes
    assert anchored(axes) == pytest.approx([1.02, 1.0] if beside else [0.0, under])


def test_a_legend_may_belong_to_a_part_of_a_figure() -> None:
    part = Figure(figsize=(10.0, 4.0)).subfigures(1, 2)[0]
    axes = part.add_axes((0.0, 0.25, 1.0, 0.5))  # five inches of ten
    axes.plot([1, 2], label="a")
    add_legend(axes)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a"]


def test_a_legend_shows_the_handles_that_it_is_given() -> None:
    axes = new_axes()
    first, second = (axes.plot([1, 2], label=label)[0] for label in "ab")
    add_legend(axes, [second])
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["b"]
    assert axes.get_legend().get_title().get_text() == ""
    add_legend(axes, [])
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["b"]
    assert first.get_label() == "a"


def test_new_axes_have_the_size_that_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    from matplotlib import pyplot

    monkeypatch.setattr(pyplot, "figure", Figure)
    figure = axes_for(None, figsize=(3.0, 2.0)).figure
    assert tuple(figure.get_size_inches()) == (3.0, 2.0)
    assert figure.get_layout_engine().__class__.__name__ == "ConstrainedLayoutEngine"


def test_a_figure_has_its_size_its_title_and_one_picture() -> None:
    drawn = []
    figure = figure_of(drawn.append, "a $title", (3.0, 2.0))
    assert len(drawn) == 1
    assert drawn == figure.axes
    assert tuple(figure.get_size_inches()) == (3.0, 2.0)
    assert figure.get_suptitle() == "a $title"
    (title,) = (each for each in figure.findobj(Text) if each.get_text() == "a $title")
    assert not title.get_parse_math()
    usual = figure_of(drawn.append)
    assert tuple(usual.get_size_inches()) == (7.2, 4.6)
    head(usual, "")
    assert usual.get_suptitle() == ""


def test_a_bitmap_has_the_figure_s_proportions() -> None:
    content = content_of(new_figure(2.0, 1.0), "png")
    height, width, _ = imread(io.BytesIO(content)).shape
    assert width == 2 * height


def test_bars_join_where_one_ends_and_the_next_begins() -> None:
    starts = np.array([0.0, 1.0, 3.0, 3.0, 6.0, 10.0])
    assert bars_of(starts, 15.0, np.array([1, 1, 1, 0, 1, 1], bool)) == [(0.0, 3.0), (6.0, 9.0)]
    assert bars_of(starts, 15.0, np.array([0, 1, 0, 1, 0, 1], bool)) == [(1.0, 5.0), (10.0, 5.0)]
    # A break of more than rounding is a break.
    gap = np.array([0.0, 2.0, 2.0 + 2e-8, 4.0])
    assert len(bars_of(gap, 1e3, np.array([1, 0, 1, 1], bool))) == 2
    assert len(bars_of(np.array([0.0, 2.0, 2.0 + 1e-12]), 1e3, np.array([1, 0, 1], bool))) == 1


def test_strips_have_room_of_their_own() -> None:
    axes = new_axes()
    axes.set_ylim(-3.0, 5.0)
    draw_strips(axes, [])
    assert axes.get_ylim() == (-3.0, 5.0)
    assert not axes.lines
    draw_strips(axes, [Strip("upper", [(1.0, 2.0), (5.0, 0.5)], True), Strip("lower", [(3.0, 4.0)], False)])
    room = 0.06 * 2.3
    assert axes.get_ylim() == pytest.approx((-3.0 - 8.0 * room / (1 - room), 5.0))
    lower, upper = axes.collections
    (corners,) = (path.vertices[:4] for path in lower.get_paths())
    np.testing.assert_allclose(corners, [(3, 0.009), (3, 0.051), (7, 0.051), (7, 0.009)])
    starts = [path.vertices[0].tolist() for path in upper.get_paths()]
    assert starts == [pytest.approx([1.0, 0.069]), pytest.approx([5.0, 0.069])]
    assert [path.vertices[2, 0] for path in upper.get_paths()] == [3.0, 5.5]
    assert [to_hex(each.get_facecolor()[0]) for each in (lower, upper)] == ["#0072b2", "#d55e00"]
    assert [each.get_linewidth()[0] for each in (lower, upper)] == [0, 0]
    (border,) = axes.lines
    np.testing.assert_allclose(border.get_xydata(), [(0.0, room), (1.0, room)])
    assert border.get_transform() == axes.transAxes
    assert lower.get_offset_transform() is not None
    shares = [(text.xy, text.xyann) for text in axes.texts]
    assert shares == [((1.0, pytest.approx(0.03)), (5, 0)), ((1.0, pytest.approx(0.09)), (5, 0))]
    assert [(text.get_parse_math(), text.get_annotation_clip()) for text in axes.texts] == 2 * [
        (False, False)
    ]


def test_strips_leave_the_limits_of_time() -> None:
    axes = new_axes()
    axes.plot([0.0, 1.0], [0.0, 1.0])
    axes.set_xlim(0.0, 1.0)
    draw_strips(axes, [Strip("part", [(0.0, 50.0)], False)])
    assert axes.get_xlim() == (0.0, 1.0)
    assert axes.dataLim.x1 == 1.0


@pytest.mark.parametrize(
    ("largest", "factor", "prefix"),
    [
        (0.8, 1.0, ""),
        (0.79, 1e-3, "m"),
        (8e5, 1e6, "M"),
        (7.9e5, 1e3, "k"),
        (8e-7, 1e-6, "µ"),
        (1e-15, 1e-9, "n"),
        (0.0, 1.0, ""),
        (-3e-3, 1.0, ""),
    ],
)
def test_a_prefix_fits_from_eight_tenths_on(largest: float, factor: float, prefix: str) -> None:
    assert prefix_for(largest, "m") == (factor, prefix)
    assert prefix_for(largest, "rad") == (1.0, "")


def test_a_value_is_written_with_its_prefix() -> None:
    assert with_prefix(-4.0123456e-5, "m") == "-40.12 µm"
    assert with_prefix(4.0123456e-5, "m", 6) == "40.1235 µm"
    assert with_prefix(0.25, "") == "0.25"


def test_an_axis_looks_at_both_of_its_ends() -> None:
    axis = new_axes().yaxis
    axis.set_view_interval(-3e-3, 1e-6, ignore=True)
    name_axis(axis, "a $rate", "m/s")
    assert axis.get_label_text() == "a $rate, mm/s"
    assert not axis.label.get_parse_math()


@pytest.mark.filterwarnings("ignore::trimmer.errors.LetterWarning")
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["_hidden", "$x$", "$\\frac{$", "a$ \\$ $b", "中文", "m" * 500, "\\"])
def test_no_name_acts_in_a_label_or_is_lost(name: str) -> None:
    figure = new_figure(4.0, 3.0)
    axes = figure.add_subplot()
    axes.plot([0, 1], [0, 1], label=look.plain_label(name))
    add_legend(axes)
    assert content_of(figure, "svg").startswith(b"<?xml")
    (text,) = axes.get_legend().get_texts()
    shown, is_mathematics = text._preprocess_math(text.get_text())
    assert not is_mathematics
    assert shown.strip() == (name if len(name) < 100 else f"{name[:59]}…")
