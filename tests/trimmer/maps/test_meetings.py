"""Where curves over a map meet, on curves made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.maps.test_curves_by_hand import FLAT, SPANS, curve, locus
from trimmer.branches.loci.locus import LocusEnd
from trimmer.maps.meetings import _apart, _nearest, meetings
from trimmer.maps.special_curve import Meeting, SpecialCurve


def test_curves_cross_within_their_pieces_with_like_states() -> None:
    (meeting,) = meetings([FLAT, curve([(2.0, 0.0), (6.0, 4e-5)])], SPANS)
    assert meeting.curves == (0, 1)
    assert meeting.values == pytest.approx([4.0, 2e-5], rel=1e-12)
    assert (meeting.ends, meeting.distance) == (False, 0.0)
    for other in (
        curve([(2.0, 0.0), (6.0, 1.9e-5)]),
        curve([(2.0, 2.1e-5), (6.0, 4e-5)]),
        curve([(11.0, 0.0), (11.0, 4e-5)]),
        curve([(-1.0, 0.0), (-1.0, 4e-5)]),
        curve([(0.0, 2e-5), (10.0, 2e-5)]),
        curve([(2.0, 0.0), (6.0, 4e-5)], (1.0, 0.9)),
        curve([(2.0, 0.0), (6.0, 4e-5)], (1.0,)),
    ):
        assert meetings([FLAT, other], SPANS) == ()
    assert len(meetings([FLAT, curve([(2.0, 0.0), (6.0, 4e-5)], (1.0, 0.96))], SPANS)) == 1
    # What begins on the other curve crosses it there, what ends there does not.
    assert len(meetings([FLAT, curve([(4.0, 2e-5), (4.0, 4e-5)])], SPANS)) == 1
    assert meetings([FLAT, curve([(4.0, 4e-5), (4.0, 2e-5)])], SPANS) == ()
    # Of one pair they come in the order of the curve with the lower number.
    there_and_back = (
        curve([(1.0, 0.0), (3.0, 4e-5), (5.0, 0.0)]),
        curve([(10.0, 2e-5), (3.5, 2e-5), (0.0, 2e-5)]),
    )
    along = [each.values[0] for each in meetings(there_and_back, SPANS)]
    assert along == pytest.approx([2.0, 4.0], rel=1e-12)
    assert [each.values[0] for each in meetings(there_and_back[::-1], SPANS)] == pytest.approx([4.0, 2.0])
    # Two crossings of one pair, and a third curve: by their numbers.
    wave = curve([(1.0, 0.0), (3.0, 4e-5), (5.0, 0.0)])
    found = meetings([wave, curve([(0.0, 9e-5), (1.0, 9e-5)]), FLAT], SPANS)
    assert [each.curves for each in found] == [(0, 2), (0, 2)]
    assert sorted(each.values[0] for each in found) == pytest.approx([2.0, 4.0])


def test_states_are_compared_where_the_curves_cross() -> None:
    changing = SpecialCurve((locus([(0.0, 2e-5), (10.0, 2e-5)], [(0.0, 1.0), (10.0, 1.0)]),))
    for state, met in ((4.0, True), (4.49, True), (4.51, False), (3.49, False)):
        other = SpecialCurve((locus([(4.0, 0.0), (4.0, 4e-5)], [(state - 1.0, 1.0), (state + 1.0, 1.0)]),))
        assert bool(meetings([changing, other], SPANS)) == met


def test_states_are_compared_with_their_largest_sizes_on_either_curve() -> None:
    # At the crossing the states differ by 0.2 and 2e-4; the largest are 10 and 1e-2.
    small = SpecialCurve((locus([(0.0, 2e-5), (10.0, 2e-5)], [(-1.0, 1e-3), (-1.0, 1e-3)]),))
    large = [(-1.2, 1.2e-3), (-1.2, 1.2e-3), (-10.0, 1e-2)]
    crossing = SpecialCurve((locus([(4.0, 0.0), (4.0, 3e-5), (4.0, 4e-5)], large),))
    assert len(meetings([small, crossing], SPANS)) == len(meetings([crossing, small], SPANS)) == 1
    for states in ([*large[:2], (-3.9, 1e-2)], [*large[:2], (-10.0, 3.9e-3)]):
        other = SpecialCurve((locus([(4.0, 0.0), (4.0, 3e-5), (4.0, 4e-5)], states),))
        assert meetings([small, other], SPANS) == meetings([other, small], SPANS) == ()


@pytest.mark.parametrize("reason", list(LocusEnd))
def test_a_curve_that_was_lost_ends_on_another_within_a_share_of_the_ranges(reason: LocusEnd) -> None:
    may_end = reason in (LocusEnd.LOST, LocusEnd.CHANGED, LocusEnd.CUSP)
    for share, near in ((0.019, True), (0.021, False)):
        ending = curve([(4.0, 4e-5), (4.0, 2e-5 + share * 4e-5)], reason=reason)
        for curves in ([FLAT, ending], [ending, FLAT]):
            found = meetings(curves, SPANS)
            assert len(found) == (near and may_end)
            for meeting in found:
                assert meeting.ends
                assert meeting.values == pytest.approx([4.0, 2e-5 + share * 4e-5], rel=1e-12)
                assert meeting.distance == pytest.approx(share, rel=1e-9)
    other = curve([(4.0, 4e-5), (4.0, 2.04e-5)], (1.0, 0.9), LocusEnd.LOST)
    assert meetings([FLAT, other], SPANS) == ()


def test_a_point_is_nearest_to_a_piece_inside_or_at_its_ends() -> None:
    first, last = np.array([1.0, 2.0]), np.array([5.0, 5.0])
    inside = first + 0.3 * (last - first) + 0.7 * np.array([-3.0, 4.0])
    assert _nearest(first, last, inside) == pytest.approx(0.3, rel=1e-12)
    assert _nearest(first, last, first - 1.0) == 0.0
    assert _nearest(first, last, last + 1.0) == 1.0
    assert _nearest(first, first, last) == 0.0


def test_of_meetings_that_are_near_one_is_kept_an_end_before_a_crossing() -> None:
    def at(share: float, ends: bool, distance: float, pair: tuple[int, int] = (0, 1)) -> Meeting:
        return Meeting(pair, np.array([4.0 + share * 10.0, 2e-5]), ends, distance)

    crossing, near, end = at(0.0, False, 0.0), at(0.019, True, 0.01), at(0.0, True, 0.002)
    assert _apart([crossing, near, end], SPANS) == [end]
    apart = at(0.021, False, 0.0)
    assert _apart([apart, crossing], SPANS) == [apart, crossing]
    other = at(0.0, False, 0.0, (0, 2))
    assert _apart([other, crossing], SPANS) == [crossing, other]
