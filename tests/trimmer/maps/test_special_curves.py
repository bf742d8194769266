"""Curves over a map: those that are found, which points lie on them, and where they meet."""

import re
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.maps.machines import impact_oscillator
from trimmer import MotionMap, SerialRunner, SpecialKind, motion_map, special_curves
from trimmer.branches import Locus, LocusEnd, SpecialPoint
from trimmer.errors import MapError, WrongTypeError
from trimmer.maps import SpecialCurve, SpecialCurves
from trimmer.maps.meetings import meetings
from trimmer.runners import ProcessRunner

PLACES = ("frequency", "stops.wall.gap")
SPANS = np.array([10.0, 4e-5])


class Backwards:
    """A runner of another kind: it takes all pieces and does the last one first."""

    def results(self, work, pieces):
        return map(work, reversed(list(pieces)))


def amplitude(frequency: np.ndarray) -> np.ndarray:
    omega = 2 * np.pi * frequency
    return np.asarray(100.0 / abs(40.0 - omega**2 + 0.1j * np.sqrt(40.0) * omega))


def around(*frequencies: float) -> MotionMap:
    values = {"frequency": frequencies, "stops.wall.gap": [9.9, 10.1]}
    return motion_map(impact_oscillator(), values, runner=SerialRunner(), quiet=True)


@pytest.fixture(scope="module")
def found() -> SpecialCurves:
    """Beside the period doubling at 5.556719 rad/s, which is left out."""
    return special_curves(around(0.878, 0.8845), lines=1, most_curves=1, runner=Backwards(), quiet=True)


def assert_passes(curve: SpecialCurve, omega: float) -> None:
    assert sorted(curve.values[[0, -1], 1]) == pytest.approx([9.9, 10.1], rel=1e-9)
    (at,) = np.flatnonzero(curve.values[:, 1] == 10.0)
    assert 2 * np.pi * curve.values[at, 0] == pytest.approx(omega, rel=1e-9)
    assert curve.residual < 1e-10


def test_a_grazing_is_that_in_closed_form(found: SpecialCurves) -> None:
    (grazing,) = found.curves
    assert (grazing.kind, grazing.parts) == (SpecialKind.GRAZING, ("wall",))
    assert grazing.values[:, 1] == pytest.approx(amplitude(grazing.values[:, 0]), rel=1e-9)
    assert_passes(grazing, 5.534678554)


def test_it_is_said_where_curves_were_looked_for_and_what_was_left(found: SpecialCurves) -> None:
    assert "at stops.wall.gap = 10: 2 special points, which lie on 1 curve" in found.searched
    assert re.search(r"; \d special points more were not followed", found.searched)
    assert "come and go between two neighbouring orbits" in found.searched
    assert "1 curve: 1 of grazing" in repr(found)


@pytest.mark.slow
def test_curves_do_not_depend_on_who_follows_them() -> None:
    cells = around(0.86, 0.8865)
    runners = (SerialRunner(), ProcessRunner(2, chunk=1))
    alone, shared = (special_curves(cells, lines=2, runner=runner, quiet=True) for runner in runners)
    assert len(alone.curves) == len(shared.curves) == 2
    assert alone.searched == shared.searched
    for one, other in zip(alone.curves, shared.curves, strict=True):
        assert np.array_equal(one.values, other.values)
        assert np.array_equal(one.states, other.states)
    _, doubling = special_curves(cells, lines=1, runner=SerialRunner(), quiet=True).curves
    assert (doubling.kind, doubling.periods) == (SpecialKind.PERIOD_DOUBLING, 1)
    assert_passes(doubling, 5.5567187941)


@pytest.mark.parametrize(
    "values", [{"frequency": [1.0, 1.1]}, {"frequency": [1.0, 1.1], "stops.wall.gap": [10.0]}]
)
def test_curves_need_several_values_of_two_numbers(values: dict[str, list[float]]) -> None:
    cells = motion_map(impact_oscillator(), values, most_periods=2, runner=SerialRunner())
    with pytest.raises(MapError, match="several values each"):
        special_curves(cells, runner=SerialRunner(), quiet=True)
    for name in ("lines", "most_curves"):
        with pytest.raises(ValueError, match=name):
            special_curves(cells, **{name: 0})
    with pytest.raises(WrongTypeError, match="result"):
        special_curves(values)  # type: ignore[arg-type]


def locus(values: list, states: list, reason: LocusEnd = LocusEnd.LEFT) -> Locus:
    residual = np.array([np.nan, *np.arange(1.0, len(values))]) * 1e-13
    given = np.array(values, dtype=float), np.array(states, dtype=float)
    return Locus(SpecialKind.FOLD, (), PLACES, 2, *given, residual, residual, reason, "it ends", ("Hz", "m"))


UP = locus([(3.0, 1e-5), (4.0, 2e-5), (6.0, 3e-5)], [(1.0, 10.0), (2.0, 20.0), (3.0, 30.0)])
DOWN = locus([(3.0, 1e-5), (1.0, 0.5e-5)], [(1.0, 10.0), (0.5, 5.0)])
BOTH = SpecialCurve((UP, DOWN))


def test_both_sides_make_one_curve_from_end_to_end() -> None:
    assert BOTH.values.tolist() == [[1.0, 0.5e-5], [3.0, 1e-5], [4.0, 2e-5], [6.0, 3e-5]]
    assert BOTH.states[:, 0].tolist() == [0.5, 1.0, 2.0, 3.0]
    assert (BOTH.ends, BOTH.residual, BOTH.periods) == ((DOWN, UP), 2e-13, 2)
    closed = SpecialCurve((UP,))
    assert closed.values.tolist() == UP.values.tolist()
    assert closed.ends == (UP,)
    assert "fold over frequency and stops.wall.gap, 4 points" in repr(BOTH)


def test_curves_are_drawn_by_name_and_told_by_kind() -> None:
    grazing = SpecialCurve((replace(DOWN, kind=SpecialKind.GRAZING, parts=("wall",)),))
    several = SpecialCurves((grazing, BOTH, SpecialCurve((UP,))), "here")
    assert [name for name, _ in several.drawn] == ["fold", "fold", "grazing, wall"]
    assert several.drawn[0][1] is BOTH.values
    assert "3 curves: 1 of grazing, 2 of fold" in repr(several)
    frame = several.to_dataframe()
    assert frame.iloc[0].tolist() == [0, "grazing", "wall", 2, 3.0, 1e-5]
    assert frame.iloc[2].tolist() == [1, "fold", "", 2, 1.0, 0.5e-5]
    assert len(frame) == 2 + 4 + 3
    assert list(frame.attrs["units"].values())[4:] == ["Hz", "m"]
    assert "0 curves" in repr(SpecialCurves((), "here"))


AT = 3.5, 1.5e-5  # The middle of a piece of ``BOTH``, where its states are 1.5 and 15


@pytest.mark.parametrize(
    ("first", "second", "states", "held"),
    [
        (*AT, (1.5, 15.0), True),
        (1.0, 0.5e-5, (0.5, 5.0), True),
        (6.0, 3e-5, (3.0, 30.0), True),
        (6.2, 3.1e-5, (3.0, 30.0), False),
        # States may be 5 % of the largest apart, which are 3 and 30.
        (*AT, (1.64, 13.6), True),
        (*AT, (1.66, 15.0), False),
        (*AT, (1.5, 13.4), False),
        # The numbers 5e-3 of their ranges, across the curve, which rises by 0.25 over 0.1 of these.
        (3.54, 1.5e-5, (1.5, 15.0), True),
        (3.6, 1.5e-5, (1.5, 15.0), False),
    ],
)
def test_a_curve_holds_the_points_that_lie_on_it_with_their_states(first, second, states, held) -> None:
    point = SpecialPoint(SpecialKind.FOLD, first, np.array(states))
    assert BOTH.holds(point, second, SPANS) is held
    assert not BOTH.holds(replace(point, kind=SpecialKind.TORUS), second, SPANS)
    assert not BOTH.holds(replace(point, parts=("wall",)), second, SPANS)


def curve(
    values: list[tuple[float, float]], state: tuple[float, ...] = (1.0, 1.0), reason: LocusEnd = LocusEnd.LEFT
) -> SpecialCurve:
    return SpecialCurve((locus(values, [state] * len(values), reason),))


FLAT = curve([(0.0, 2e-5), (10.0, 2e-5)])


@pytest.mark.parametrize(
    ("other", "at"),
    [
        (curve([(2.0, 0.0), (6.0, 4e-5)]), [4.0]),
        (curve([(2.0, 0.0), (6.0, 4e-5)], (1.0, 0.96)), [4.0]),
        (curve([(2.0, 0.0), (6.0, 4e-5)], (1.0, 0.9)), []),
        (curve([(2.0, 0.0), (6.0, 4e-5)], (1.0,)), []),
        (curve([(2.0, 0.0), (6.0, 1.9e-5)]), []),
        (curve([(2.0, 2.1e-5), (6.0, 4e-5)]), []),
        (curve([(11.0, 0.0), (11.0, 4e-5)]), []),
        (curve([(0.0, 2e-5), (10.0, 2e-5)]), []),
        (curve([(1.0, 0.0), (3.0, 4e-5), (5.0, 0.0)]), [2.0, 4.0]),
        # What begins on the other curve crosses it there, what ends there does not.
        (curve([(4.0, 2e-5), (4.0, 4e-5)]), [4.0]),
        (curve([(4.0, 4e-5), (4.0, 2e-5)]), []),
    ],
)
def test_curves_meet_where_they_cross_with_one_orbit(other: SpecialCurve, at: list[float]) -> None:
    for curves in ([FLAT, other], [other, FLAT]):
        met = meetings(curves, SPANS)
        assert sorted(each.values[0] for each in met) == pytest.approx(at, rel=1e-12)
        for each in met:
            assert (each.curves, each.ends, each.distance) == ((0, 1), False, 0.0)
            assert each.values[1] == pytest.approx(2e-5, rel=1e-12)


@pytest.mark.parametrize("reason", list(LocusEnd))
@pytest.mark.parametrize(("share", "near"), [(0.019, True), (0.021, False)])
def test_a_curve_that_was_lost_ends_on_another_within_a_share_of_the_ranges(reason, share, near) -> None:
    may_end = reason in (LocusEnd.LOST, LocusEnd.CHANGED, LocusEnd.CUSP)
    ending = curve([(4.0, 4e-5), (4.0, 2e-5 + share * 4e-5)], reason=reason)
    far = curve([(0.0, 9e-5), (1.0, 9e-5)])
    for curves, pair in (([FLAT, far, ending], (0, 2)), ([ending, FLAT, far], (0, 1))):
        met = meetings(curves, SPANS)
        assert len(met) == (near and may_end)
        for each in met:
            assert (each.curves, each.ends) == (pair, True)
            assert each.values == pytest.approx([4.0, 2e-5 + share * 4e-5], rel=1e-12)
            assert each.distance == pytest.approx(share, rel=1e-9)
    other = curve([(4.0, 4e-5), (4.0, 2.04e-5)], (1.0, 0.9), LocusEnd.LOST)
    assert meetings([FLAT, other], SPANS) == ()


def test_of_meetings_near_one_another_the_end_is_kept() -> None:
    # It crosses the other at 4 and is lost 0.01 of the range behind.
    through = curve([(4.0, 4e-5), (4.0, 1.96e-5)], reason=LocusEnd.LOST)
    (meeting,) = meetings([FLAT, through], SPANS)
    assert meeting.ends
    assert meeting.values == pytest.approx([4.0, 1.96e-5], rel=1e-12)
