"""All results draw what they did, into axes that are given; transcripts of commands tell of ``--plot``."""

import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from subprocess import run

import matplotlib
import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import trimmer
from tests.public_names import public_names
from tests.trimmer import results
from tests.trimmer.command_line.alike import NUMBER
from tests.trimmer.drawing.pictures import FIGURES, PLOTS, in_words, kept, new_axes, pictures
from trimmer.errors import WrongTypeError
from trimmer.showing.drawn import Drawn

LAID_OUT = ("HarmonicBalance", "Motion", "FollowedBranch", "MotionMap", "SpectrumAnalysis")
ROUNDING = 3e-4  # What noise leaves of a fit, and the last of five digits


@pytest.fixture(autouse=True)
def without_window() -> Iterator[None]:
    with matplotlib.rc_context({"backend": "agg"}):
        pyplot.close("all")
        yield
        pyplot.close("all")


@cache
def small(name: str) -> Axes:
    """Draw a result into axes that leave little room, and into nothing else."""
    settings = dict(matplotlib.rcParams)
    axes = Figure(figsize=(3.5, 3.2), layout="constrained").add_subplot()
    assert PLOTS[name](axes) is axes
    assert dict(matplotlib.rcParams) == settings
    assert not pyplot.get_fignums()
    return axes


@pytest.mark.parametrize("name", pictures())
def test_a_picture_is_what_it_was(name: str) -> None:
    before, now = kept()[name], in_words(FIGURES[name]() if name in FIGURES else small(name).figure)
    assert [NUMBER.sub("#", line) for line in now.splitlines()] == [
        NUMBER.sub("#", line) for line in before.splitlines()
    ]
    for one, other in zip(now.splitlines(), before.splitlines(), strict=True):
        numbers = [[float(each) for each in NUMBER.findall(line)] for line in (one, other)]
        np.testing.assert_allclose(*numbers, rtol=ROUNDING, atol=2e-11, err_msg=other)


def test_all_public_results_with_a_plot_are_drawn() -> None:
    public = public_names()
    with_plot = {name for name, each in public.items() if isinstance(each, type) and hasattr(each, "plot")}
    elements = {name for name in with_plot if issubclass(public[name], trimmer.elements.Element)}
    assert with_plot - elements <= {name.split(",")[0] for name in PLOTS}
    assert len(elements) > 5
    assert list(kept()) == list(pictures())


@pytest.mark.parametrize("name", PLOTS)
def test_axes_that_are_given_are_drawn_into_and_no_others(name: str) -> None:
    axes = small(name)
    for wrong in (axes.figure, "axes", 3):
        with pytest.raises(WrongTypeError, match="ax must be Matplotlib axes"):
            PLOTS[name](wrong)


@pytest.mark.parametrize(
    "name", [pytest.param(each, marks=[] if each in LAID_OUT else pytest.mark.slow) for each in PLOTS]
)
def test_labels_and_legend_have_room(name: str) -> None:
    assert_all_is_seen(small(name))


def assert_all_is_seen(axes: Axes) -> None:
    """Assert that the labels lie in the figure, and the legend in it too and clear of the data."""
    figure = axes.figure
    figure.draw_without_rendering()
    texts, paper = [axes.xaxis.label, axes.yaxis.label], figure.bbox.padded(1)
    if axes.get_legend() is not None:
        texts.append(axes.get_legend())
        assert not axes.get_window_extent().overlaps(axes.get_legend().get_window_extent())
    for text in texts:
        box = text.get_window_extent()
        assert paper.contains(box.x0, box.y0)
        assert paper.contains(box.x1, box.y1)


@pytest.mark.parametrize(("width", "beside"), [(4.0, True), (3.99, False)])
def test_a_legend_stands_beside_axes_from_four_inches_on_and_else_under_them(
    width: float, beside: bool
) -> None:
    axes = Figure(figsize=(2 * width, 10.0)).add_axes((0.1, 0.5, 0.5, 0.25))
    results.balance().plot(axes)
    assert_all_is_seen(axes)
    data, legend = axes.get_window_extent(), axes.get_legend().get_window_extent()
    gap = (legend.x0 - data.x1) / data.width if beside else (data.y0 - legend.y1) / axes.figure.dpi * 72
    assert gap == pytest.approx(0.02 if beside else 36.0, rel=1e-3)  # 3.6 font sizes
    assert (legend.y1 == pytest.approx(data.y1)) if beside else (legend.x0 == pytest.approx(data.x0))


def test_axes_of_a_part_of_a_figure_have_a_legend_too() -> None:
    part = Figure(figsize=(10.0, 4.0)).subfigures(1, 2)[0]
    assert results.time_response().plot(part.subplots()).get_legend() is not None


def test_new_axes_are_of_pyplot_and_are_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pyplot, "show", lambda *_, **__: pytest.fail("shown"))
    settings = dict(matplotlib.rcParams)
    axes = results.signal().plot()
    assert axes.figure is pyplot.gcf()
    assert axes.figure.get_layout_engine().__class__.__name__ == "ConstrainedLayoutEngine"
    assert dict(matplotlib.rcParams) == settings


def test_what_cannot_be_drawn_leaves_no_empty_figure() -> None:
    with pytest.raises(ValueError, match="has no loop, so there is nothing to draw"):
        replace(results.balance(), loop=None).plot()
    assert not pyplot.get_fignums()


def test_a_picture_of_a_signal_needs_no_loop_and_no_mechanism() -> None:
    told = "import trimmer, sys; trimmer.Signal([0.0, 1.0], 1.0).plot(); print(*sys.modules)"
    loaded = run([sys.executable, "-c", told], capture_output=True, text=True, check=True).stdout.split()
    assert "trimmer.drawing.signals.samples" in loaded
    assert not {"control", "numba", "trimmer.mechanism", "trimmer.balance"} & set(loaded)


def test_what_is_no_result_has_no_picture() -> None:
    class Lonely(Drawn):
        pass

    with pytest.raises(TypeError, match="there is no picture of Lonely"):
        Lonely().plot(new_axes())


def test_lines_are_told_apart_without_their_colours(tmp_path: Path) -> None:
    """Each of six lines has dashes of its own, the first has none."""
    response = trimmer.linear.TimeResponse(np.arange(3.0), np.ones((5, 3)), np.ones((1, 3)), np.ones((1, 3)))
    axes = response.plot(new_axes())
    assert [each.get_linestyle() for each in axes.lines] == ["-", *(5 * ["--"])]
    axes.figure.savefig(tmp_path / "a.svg")
    drawn = (tmp_path / "a.svg").read_text("utf-8")
    assert len(set(re.findall('stroke-dasharray: ([^;"]*)', drawn))) == 5
