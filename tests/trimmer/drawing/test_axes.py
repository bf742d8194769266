"""Axes that are given and made, and legends."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import matplotlib
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import trimmer
from tests.trimmer import results
from trimmer.drawing.axes import add_legend, axes_for
from trimmer.errors import WrongTypeError

PLOTS: dict[str, Callable[..., Axes]] = {
    "HarmonicBalance": lambda ax=None: results.balance().plot(ax),
    "HarmonicBalance, near": lambda ax=None: results.balance().plot(ax, near=True),
    "Identification": lambda ax=None: results.identification().plot(ax),
    "FrictionBacklash": lambda ax=None: results.PLAY.plot(ax),
    "FrictionBacklash, locus": lambda ax=None: results.PLAY.plot_locus(ax),
    "InertiaBacklash": lambda ax=None: trimmer.InertiaBacklash(4e-5).plot(ax),
    "ViscousBacklash": lambda ax=None: trimmer.ViscousBacklash(4e-5, 1e-3).plot(ax, omega=4600.0),
    "Relay": lambda ax=None: trimmer.Relay(1.0).plot_locus(ax),
    "PeriodicOrbits": lambda ax=None: results.orbits().plot(ax),
    "PeriodicOrbit": lambda ax=None: results.orbits()[0].plot(ax),
    "Motion": lambda ax=None: results.driven().plot(ax),
    "MechanismMotion": lambda ax=None: results.stopped().plot(ax),
    "MechanismOrbit": lambda ax=None: results.forced().plot(ax),
    "Response": lambda ax=None: results.response().plot(ax),
    "FollowedBranch": lambda ax=None: results.branch().plot(ax),
    "MotionMap": lambda ax=None: results.motion_map().plot(ax),
    "Basin": lambda ax=None: results.basin().plot(ax),
    "SpecialCurves": lambda ax=None: results.curves().plot(ax),
    "SpecialCurve": lambda ax=None: results.curves().curves[0].plot(ax),
    "Locus": lambda ax=None: results.locus().plot(ax),
    "LinearSummary": lambda ax=None: results.summary().plot(ax),
    "TimeResponse": lambda ax=None: results.time_response().plot(ax),
    "Signal": lambda ax=None: results.signal().plot(ax),
    "SpectrumAnalysis": lambda ax=None: results.analysis().plot(ax),
    "Spectrum": lambda ax=None: results.analysis().spectrum.plot(ax),
    "AveragedSpectrum": lambda ax=None: results.averaged().plot(ax),
    "Comparison": lambda ax=None: results.comparison().plot(ax),
    "HarmonicFit": lambda ax=None: results.analysis().harmonics.plot(ax),
    "Fit": lambda ax=None: results.fit().plot(ax),
}
"""A way to draw each kind of result."""


@pytest.fixture(autouse=True)
def without_window() -> Iterator[None]:
    with matplotlib.rc_context({"backend": "agg"}):
        pyplot.close("all")
        yield
        pyplot.close("all")


def test_all_public_results_with_a_plot_are_tried() -> None:
    public = {name: getattr(trimmer, name) for name in trimmer.__all__}
    with_plot = {name for name, each in public.items() if isinstance(each, type) and hasattr(each, "plot")}
    elements = {name for name in with_plot if issubclass(public[name], trimmer.Element)}
    assert with_plot - elements <= {name.split(",")[0] for name in PLOTS}
    assert len(elements) > 5


@pytest.mark.parametrize("name", PLOTS)
def test_axes_that_are_given_are_drawn_into_and_returned(name: str) -> None:
    plot = PLOTS[name]
    settings = dict(matplotlib.rcParams)
    axes = Figure(figsize=(3.5, 3.2), layout="constrained").add_subplot()
    assert plot(axes) is axes
    assert axes.has_data()
    assert axes.get_xlabel()
    assert axes.get_ylabel()
    assert axes.xaxis.get_gridlines()[0].get_visible() == (name not in ("MotionMap", "Basin"))
    assert_all_is_seen(axes)
    assert dict(matplotlib.rcParams) == settings
    assert not pyplot.get_fignums()


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


@pytest.mark.parametrize(("size", "beside"), [((7.2, 4.6), True), ((3.5, 3.2), False)])
def test_a_legend_stands_beside_wide_axes_and_under_narrow_ones(
    size: tuple[float, float], beside: bool
) -> None:
    axes = results.balance().plot(Figure(figsize=size, layout="constrained").add_subplot())
    assert_all_is_seen(axes)
    data, legend = axes.get_window_extent(), axes.get_legend().get_window_extent()
    assert (legend.x0 > data.x1) == beside
    assert (legend.y1 < data.y0) != beside


def test_new_axes_are_of_pyplot_and_are_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pyplot, "show", lambda *_, **__: pytest.fail("shown"))
    settings = dict(matplotlib.rcParams)
    axes = results.signal().plot()
    assert axes.figure is pyplot.gcf()
    assert dict(matplotlib.rcParams) == settings


@pytest.mark.parametrize("wrong", [Figure(), "axes", 3])
def test_what_is_no_axes_is_refused(wrong: object) -> None:
    with pytest.raises(WrongTypeError, match="ax must be Matplotlib axes"):
        axes_for(wrong)  # type: ignore[arg-type]


def test_a_legend_has_each_label_once_and_none_without_labels() -> None:
    axes = Figure().add_subplot()
    add_legend(axes)
    assert axes.get_legend() is None
    for label in ("a", "b", "a"):
        axes.plot([0, 1], [0, 1], label=label)
    add_legend(axes)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a", "b"]
