"""Ranges that are searched, undecided regions and the words of a certificate, from hand-made parts."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER, s
from trimmer.balance.bounded import (
    _cut,
    _next_to_poles,
    _range_of_roots,
    _range_with_all,
    _rough_gain,
    _smallest_gain,
    solve_bounded,
)
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainTable
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.limit_cycle import Certificate, HarmonicBalance, LimitCycle, UndecidedRegion
from trimmer.balance.search import SearchResult
from trimmer.balance.solve import _checked_range, _has_zero_on_axis, harmonic_balance, undecided_regions
from trimmer.balance.vanishing import EmptyInterval
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.saturation import Saturation
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.errors import FrequencyRangeError

INVERSE = InverseResponse(1.0 + 0j, np.array([0.0, -2.0, -5.0 + 0j]), np.array([-0.5 + 0j]), 10.0)
PLAY = ElementCurve(FrictionBacklash(4e-5))


def cells(*limits: tuple[float, float, float, float]) -> Cells:
    return Cells(*np.array(limits, float).reshape(-1, 4).T)


def test_the_range_of_the_roots_goes_two_beyond_them() -> None:
    assert _range_of_roots(INVERSE) == pytest.approx((math.log(5.0) - 2.0, math.log(50.0) + 2.0))
    integrators = InverseResponse(1.0 + 0j, np.zeros(2, complex), np.zeros(0, complex), 1.0)
    assert _range_of_roots(integrators) == (-2.0, 2.0)


def test_the_range_that_is_reported_holds_all_that_was_found() -> None:
    nothing = SearchResult(np.empty(0), np.empty(0), Cells.none(), 0)
    assert _range_with_all(nothing, (-2.0, 3.0)) == pytest.approx((math.exp(-2.0), math.exp(3.0)))
    found = SearchResult(np.ones(2), np.array([-4.0, 7.0]), cells((0.0, 1.0, 0.0, 1.0)), 9)
    assert _range_with_all(found, (-2.0, 3.0)) == pytest.approx((math.exp(-4.5), math.exp(7.5)))
    undecided = SearchResult(np.empty(0), np.empty(0), cells((0.0, 1.0, -6.0, 8.0)), 9)
    assert _range_with_all(undecided, (-2.0, 3.0)) == pytest.approx((math.exp(-6.5), math.exp(8.5)))
    near = SearchResult(np.ones(1), np.array([-1.8]), Cells.none(), 9)
    assert _range_with_all(near, (-2.0, 3.0)) == pytest.approx((math.exp(-2.3), math.exp(3.0)))


def test_breaks_are_cut_at_empty_intervals_and_begin_beyond_those_at_the_origin() -> None:
    breaks = np.array([0.0, 1.0, 2.0, 3.0])
    inner, low = EmptyInterval(1.5, 2.5, 0.1), EmptyInterval(-math.inf, 0.5, 0.1)
    assert _cut(breaks, (inner,)).tolist() == [0.0, 1.0, 1.5, 2.0, 2.5, 3.0]
    assert _cut(breaks, (inner, low)).tolist() == [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
    assert _cut(breaks, (EmptyInterval(-math.inf, 3.0, 0.1),)).tolist() == [0.0, 1.0, 2.0, 3.0]
    assert _cut(breaks, (EmptyInterval(-1.0, 9.0, 0.1),)).tolist() == [0.0, 1.0, 2.0, 3.0]
    assert _cut(breaks, (EmptyInterval(-math.inf, 2.0, 0.1),)).tolist() == [2.0, 3.0]


def test_what_is_left_out_depends_on_what_is_proven_next_to_poles() -> None:
    table = GainTable.of(PLAY, np.array([0.0, 1.0]))
    assert table.smallest_gain == 0.0
    largest = table.largest_gain
    near, far = EmptyInterval(0.0, 1.0, 1e-14), EmptyInterval(0.0, 1.0, 1e-3)
    assert _smallest_gain([], table) == 0.0
    assert _smallest_gain([far], table) == 0.0
    assert _smallest_gain([far, near], table) == pytest.approx(1e-13 * largest, rel=1e-6, abs=0.0)
    assert _smallest_gain([far, None], table) == pytest.approx(1e-10 * largest)
    full = GainTable.of(ElementCurve(Saturation(2.0, 1.0)), np.array([0.0, 1.0]))
    bounded = replace(full, disks=replace(full.disks, centre=full.disks.centre + 9.0))
    assert bounded.smallest_gain > 0.0
    assert _smallest_gain([None], bounded) == 0.0


def test_only_the_poles_that_matter_are_looked_at() -> None:
    breaks = np.array([-3.0, 0.0, 3.0])

    def found(*poles: complex, given: np.ndarray = breaks, curve: ElementCurve = PLAY) -> int:
        response = InverseResponse(1.0 + 0j, np.array(poles), np.zeros(0, complex), 1.0)
        return len(_next_to_poles(response, curve, given))

    assert found(-1.0 + 0j, -2.0) == 0
    assert found(2j, -2j) == 2
    assert found(2j, -2j, given=np.array([1.0, 2.0])) == 0  # ln 2 is below
    assert found(2j, -2j, given=np.array([-1.0, 0.5])) == 0  # and above
    # |1/G| at e**-3 is 0.05, not small beside N; at e**-12 it is 6e-6.
    assert found(0j, -1.0) == 0
    assert found(0j, -1.0, given=np.array([-12.0, 3.0])) == 1
    assert found(0j, 2j, -2j, given=np.array([-12.0, 3.0])) == 3


def test_a_rough_bound_of_n_holds_at_all_amplitudes() -> None:
    curve = ElementCurve(FrictionBacklash(4e-5))
    u = np.linspace(1e-6, 2.0 - 1e-6, 500)
    largest = np.abs(curve.value(u, np.zeros(500))).max()
    disk = curve.disks(cells((0.0, 2.0, -1.0, 1.0)))
    assert _rough_gain(curve, np.array([-1.0, 0.5, 1.0])) == pytest.approx(
        float(np.abs(disk.centre[0]) + disk.radius[0])
    )
    assert _rough_gain(curve, np.array([-1.0, 0.5, 1.0])) > largest


def test_without_a_range_all_frequencies_are_covered() -> None:
    response = InverseResponse(0.1 + 0j, np.array([-1.0, -2.0, -0.5 + 0j]), np.zeros(0, complex), 3.0)
    searched = solve_bounded(response, PLAY, None)
    assert searched.outside_excluded
    assert searched.omegas[0] <= 1.5 * math.exp(-2.0)
    assert searched.omegas[1] >= 6.0 * math.exp(2.0)
    given = solve_bounded(response, PLAY, (0.5, 30.0))
    assert given.omegas == (0.5, 30.0)
    assert not given.outside_excluded
    assert given.result.x == pytest.approx(searched.result.x, abs=1e-9)


def test_undecided_boxes_that_touch_are_one_region() -> None:
    boxes = cells((0.5, 1.0, 2.0, 3.0), (0.25, 0.75, 1.0, 2.0), (0.5, 0.6, 4.0, 5.0), (0.5, 0.6, 4.2, 4.5))
    first, second = undecided_regions(boxes, PLAY)
    assert first.amplitudes == pytest.approx((4e-5, 16e-5))
    assert first.omegas == pytest.approx((math.exp(1.0), math.exp(3.0)))
    assert second.amplitudes == pytest.approx((4e-5 / 0.6, 8e-5))
    assert second.omegas == pytest.approx((math.exp(4.0), math.exp(5.0)))
    assert not first.at_edge
    assert undecided_regions(Cells.none(), PLAY) == ()


def test_a_wide_box_joins_what_lies_beneath_it() -> None:
    boxes = cells((0.5, 1.0, 0.0, 9.0), (0.5, 1.0, 1.0, 2.0), (0.5, 1.0, 5.0, 6.0))
    assert len(undecided_regions(boxes, PLAY)) == 1


def test_a_box_at_the_edge_is_told_and_infinite_amplitudes_too() -> None:
    (region,) = undecided_regions(cells((0.0, 2.0, 0.0, 1.0)), PLAY)
    assert region.at_edge
    assert region.amplitudes == (2e-5, math.inf)
    (inside,) = undecided_regions(cells((0.1, 2.0 * (1.0 - 2e-9), 0.0, 1.0)), PLAY)
    assert not inside.at_edge
    # A saturation keeps its gain at all smaller amplitudes.
    element = Saturation(3.0, 0.5)
    curve = ElementCurve(element)
    edge = float(element.constant_from)
    (going,) = undecided_regions(cells((0.5 * edge, edge, 0.0, 1.0)), curve)
    assert not going.at_edge
    assert going.amplitudes == (0.0, pytest.approx(element.amplitude_scale / (0.5 * edge)))
    (short,) = undecided_regions(cells((0.5 * edge, 0.9 * edge, 0.0, 1.0)), curve)
    assert short.amplitudes[0] == pytest.approx(element.amplitude_scale / (0.9 * edge))
    (relay,) = undecided_regions(cells((0.5, math.inf, 0.0, 1.0)), ElementCurve(Relay(1.0)))
    assert relay.at_edge


@pytest.mark.parametrize(
    "given", [(1.0,), (1.0, 2.0, 3.0), (0.0, 1.0), (2.0, 2.0), (1.0, math.inf), (-1.0, 1.0)]
)
def test_a_range_is_two_rising_positive_numbers(given: tuple[float, ...]) -> None:
    assert _checked_range((1, 2.5)) == (1.0, 2.5)
    with pytest.raises(FrequencyRangeError):
        _checked_range(given)


def test_zeros_on_the_axis_count_within_the_range_with_its_ends() -> None:
    inverse = replace(INVERSE, zeros=np.array([0.3j, -0.3j, -0.7 + 0.5j, -0.7 - 0.5j]))
    ranges = [(1.0, 2.9), (1.0, 3.0), (3.0, 4.0), (3.1, 9.0), (1.0, 9.0)]
    assert [_has_zero_on_axis(inverse, each) for each in ranges] == [False, True, True, False, True]


REGION = UndecidedRegion((1.0, 2.0), (3.0, 4.0))
CERTIFICATE = Certificate("by hand", (1.0, 9.0), True, 12, (), 0.0, 1, 1, False)
CYCLE = LimitCycle(0.5, 4.0 * math.pi, True, 1e-12, 1.0, 1, 0)


def test_a_limit_cycle_tells_its_frequency_and_whether_it_is_near_tangency() -> None:
    assert CYCLE.frequency == pytest.approx(2.0)
    limit = math.radians(5.0)
    assert not replace(CYCLE, crossing_angle=limit).near_tangency
    assert replace(CYCLE, crossing_angle=0.999 * limit).near_tangency


def test_a_certificate_is_complete_only_without_doubts() -> None:
    assert CERTIFICATE.complete
    assert CERTIFICATE.doubts == ()
    unknown = replace(CERTIFICATE, winding_number=None)
    assert (unknown.checked, unknown.complete) == (False, False)
    assert "cannot be told" in unknown.doubts[0]
    at_zero = replace(unknown, zero_on_axis=True)
    assert (at_zero.checked, at_zero.complete) == (True, True)
    other = replace(CERTIFICATE, winding_number=2, zero_on_axis=True)
    assert (other.checked, len(other.doubts)) == (False, 1)
    assert "is 2 and the sum of the indices 1" in other.doubts[0]
    small = replace(CERTIFICATE, smallest_gain=1e-10)
    assert (len(small.doubts), len(small.other_doubts)) == (1, 1)
    # Where something is undecided or unproven, a winding number that differs is no doubt of its own.
    open_one = replace(CERTIFICATE, undecided=(REGION,), winding_number=2)
    assert (len(open_one.doubts), open_one.other_doubts) == (1, ())
    unproven = replace(CERTIFICATE, unproven=("nothing is known",), winding_number=2)
    assert unproven.doubts == unproven.other_doubts == ("nothing is known",)
    both = replace(small, winding_number=2)
    assert len(both.other_doubts) == 2


def test_what_is_told_of_results_is_exact() -> None:
    told = "<Certificate: complete, 1 to 9 rad/s, 0 undecided regions>"
    assert repr(CERTIFICATE) == told
    not_so = told.replace("complete", "not complete").replace("0 undecided regions", "1 undecided region")
    assert repr(replace(CERTIFICATE, undecided=(REGION,))) == not_so
    rows = [list(row) for row in HarmonicBalance((CYCLE,), CERTIFICATE)._table().rows()]
    assert rows == [[0.5, CYCLE.omega, 2.0, True, 1e-12, 1.0, False, 0]]
    assert [each.unit for each in HarmonicBalance((), CERTIFICATE)._table().columns][:3] == [
        *("unit of the element's input", "rad/s", "Hz"),
    ]


def test_a_region_says_why_it_is_undecided() -> None:
    assert "touch or coincide" in REGION.reason
    assert "smallest amplitude" in replace(REGION, at_edge=True).reason


def test_a_balance_is_confirmed_by_the_winding_number_of_its_own_cycles() -> None:
    balance = HarmonicBalance((CYCLE,), CERTIFICATE)
    assert (balance.confirmed, balance.success) == (True, True)
    assert "1 limit cycle found" in balance.message
    two = HarmonicBalance(
        (CYCLE, replace(CYCLE, index=-1)), replace(CERTIFICATE, winding_number=0, index_sum=0)
    )
    assert (two.confirmed, two.success) == (True, True)
    assert "2 limit cycles found" in two.message
    wrong = replace(two, limit_cycles=(CYCLE,))
    assert (wrong.confirmed, wrong.success) == (False, False)
    unknown = replace(balance, certificate=replace(CERTIFICATE, winding_number=None, zero_on_axis=True))
    assert (unknown.confirmed, unknown.success) == (None, True)
    doubtful = replace(balance, certificate=replace(CERTIFICATE, smallest_gain=1e-9))
    assert (doubtful.confirmed, doubtful.success) == (True, False)


def test_a_certificate_holds_what_was_done() -> None:
    element = Relay(2.0) + ViscousFriction(0.1)
    balance = harmonic_balance(THIRD_ORDER, element, omega_range=(0.5, 5.0))
    certificate = balance.certificate
    assert certificate.omegas == (0.5, 5.0)
    assert not certificate.outside_excluded
    assert certificate.boxes > 0
    assert certificate.undecided == ()
    assert (certificate.smallest_gain, certificate.winding_number, certificate.index_sum) == (0.0, 1, 1)
    assert not certificate.zero_on_axis
    assert balance.loop is not None
    assert balance.loop.element is element
    # s³ + 3 s² + 2 s + 0.1 s + N: omega² = 2.1, N = 3 omega², A = 4 2/(π N).
    (cycle,) = balance.limit_cycles
    assert cycle.omega**2 == pytest.approx(2.1)
    assert cycle.amplitude == pytest.approx(8.0 / (math.pi * 6.3))
    assert (cycle.index, cycle.stable, cycle.other_unstable_poles) == (1, True, 0)
    assert cycle.residual < 1e-12
    frozen = harmonic_balance(THIRD_ORDER, element, frozen_omega=2.0).loop
    assert frozen is not None
    assert frozen.element != element
    assert harmonic_balance(20 * (s**2 + 4) / (s + 1) ** 4, FrictionBacklash(1.0)).certificate.zero_on_axis
