"""The figures of G with -1/N show what their captions say."""

import math

import numpy as np
import pytest

from report.chapters.chapter_5.figures import contours, friction
from report.pages.drawing import plane
from report.pages.drawing.letters import title_of
from tests.report.figures.lines import curve
from trimmer import response_at
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash

IDS = ("fig-5.5", "fig-5.10", "fig-5.15", "fig-5.16", "fig-5.21", "fig-5.22", "fig-5.23", "fig-5.24")


def points(axes, marker="o"):
    """Marked points as (complex, whether they are full)."""
    return [
        (complex(line.get_xdata()[0], line.get_ydata()[0]), line.get_markerfacecolor() != "white")
        for line in axes.lines
        if line.get_marker() == marker
    ]


@pytest.mark.parametrize("figure_id", IDS)
def test_every_panel_has_a_title(figure_id, drawn_axes):
    assert all(title_of(axes) and axes.get_xlabel() for axes in drawn_axes(figure_id))


def test_curves_begin_at_minus_one_and_reach_the_edge_of_their_domain():
    for element in (FrictionBacklash(1.0), InertiaBacklash(1.0)):
        points_of_curve = plane.inverse(element)
        assert abs(points_of_curve[0] + 1) < 1e-3
    assert abs(plane.inverse(FrictionBacklash(1.0))[-1]) > 20
    assert plane.inverse(InertiaBacklash(1.0))[-1] == pytest.approx(-0.25j * math.pi, abs=1e-3)


def test_the_librarys_squares_lie_on_the_listings_curve(drawn_axes):
    curves, sizes = drawn_axes("fig-5.5")
    squares, listing = curve(curves, "python-control"), curve(curves, "$-1/N$, listing")
    for square in squares:
        assert np.abs(listing - square).min() < 0.02 * abs(square) + 0.01
    listed, library = sizes.lines[:2]
    inside = np.asarray(library.get_xdata()) < 0.5
    assert (np.asarray(library.get_ydata())[inside] == 0).all()
    assert (np.asarray(listed.get_ydata())[np.asarray(listed.get_xdata()) < 0.4] > 0.1).all()


def test_the_larger_gap_has_an_open_and_a_full_point(drawn_axes, evidence):
    whole, near, *_ = drawn_axes("fig-5.10")
    ((inner, inner_full),), ((outer, outer_full),) = points(whole), points(near)
    assert not inner_full
    assert outer_full
    cycles = evidence.cycles.friction
    for point, cycle in ((inner, cycles.unstable), (outer, cycles.stable)):
        assert point == pytest.approx(complex(response_at(evidence.numbers.displacement_only, cycle.omega)))
    (text,) = (each.get_text() for each in near.texts)
    assert "332.6" in text


def test_the_thick_band_reaches_both_ends_of_the_thesis(drawn_axes, evidence):
    (axes,) = drawn_axes("fig-5.15")
    ends = curve(axes, "ends of the band")
    expected = response_at(evidence.numbers.displacement_only, np.array(contours.BAND))
    np.testing.assert_allclose(ends, expected)
    points_of_curve = curve(axes, "$-1/N$, inertia-controlled")
    farthest = max(np.abs(points_of_curve - end).min() for end in ends)
    (label,) = (text for text in axes.get_legend_handles_labels()[1] if "needs" in text)
    assert label.startswith(f"{farthest:.2f}")


def test_only_right_viscous_contours_come_near_minus_one(drawn_axes):
    _, right, _, listing = drawn_axes("fig-5.16")
    for gamma in contours.GAMMAS:
        assert np.abs(curve(right, f"$\\gamma$ = {gamma}") + 1).min() < 0.01
        assert np.abs(curve(listing, f"$\\gamma$ = {gamma}") + 1).min() > 0.3
    assert len(points(right)) == len(contours.GAMMAS)
    assert all(full for _, full in points(right))


def test_wrong_sign_bends_down_and_right_sign_bends_up(drawn_axes):
    *listings, right = drawn_axes("fig-5.21")
    for axes in listings:
        names = [each.get_label() for each in axes.lines if each.get_label() not in ("$G$", "no friction")]
        for name in names:
            if not name.startswith("_"):
                assert curve(axes, name).imag.max() < 1e-6
    for load in friction.LOADS:
        assert curve(right, f"{load:g}").imag.max() > 1


def test_friction_of_the_caption_leaves_one_point_on_the_listings_curve(drawn_axes, evidence):
    whole, near, _ = drawn_axes("fig-5.23")
    assert points(whole) == []
    ((point, _),) = points(near)
    points_of_curve = curve(near, "$-1/N$, Listing A.6")
    assert np.abs(points_of_curve - point).min() < 0.02
    response = response_at(evidence.numbers.displacement_only, plane.OMEGA)
    right = curve(near, "$-1/N$, right term over $k_2$")
    close = np.abs(right + 1) > 0.05
    assert np.abs(right[close][:, np.newaxis] - response[np.newaxis, :]).min() > 0.05


def test_branches_end_in_their_merger(drawn_axes, evidence):
    _, branch = drawn_axes("fig-5.24")
    merger = evidence.cycles.equivalent.in_place.merger
    solid = curve(branch, "thesis's loop")
    assert solid[-1] == pytest.approx(complex(merger.force_per_gap / 1e3, merger.amplitude))
    assert solid[0].imag == pytest.approx(evidence.cycles.friction.stable.amplitude)
