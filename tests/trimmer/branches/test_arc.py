"""Orbits on a piece of branch by how far along a direction they are, on a parabola (p², 3 p, p)."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, parabola
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.period_map import Phase

ALONG = np.array([0.0, 0.0, 1.0])
SLANTED = np.array([0.0, 0.6, 0.8])


def arc_of(map: OnCurve, origin: float, direction: np.ndarray = ALONG) -> Arc:
    place = map.at(origin)
    return Arc(place.problem, place.position, direction)


def on(arc: Arc, value: float) -> Place:
    map = arc.problem.map
    assert isinstance(map, OnCurve)
    return map.at(value, arc.problem)


def test_distances_are_along_the_direction_from_the_origin() -> None:
    arc = arc_of(parabola(), 0.5, SLANTED)
    assert arc.distance(on(arc, 0.75)) == pytest.approx(0.6 * 0.75 + 0.8 * 0.25, rel=1e-14)
    assert arc.distance(on(arc, 0.25)) < 0.0
    near, far = arc_of(parabola(), 0.01), arc_of(parabola(), -2000.0)
    assert near.narrowest == 1e-13
    assert far.narrowest == pytest.approx(4.0 * np.finfo(float).eps * 4e6, rel=1e-12)
    behind = Arc(far.problem, np.array([3.0, -5e6, 2.0]), ALONG)
    assert behind.narrowest == pytest.approx(4.0 * np.finfo(float).eps * 5e6, rel=1e-12)


def test_a_prediction_is_on_the_tangent() -> None:
    arc = arc_of(parabola(), 0.5, SLANTED)
    place = on(arc, 0.6)
    ahead = np.array([1.2, 3.0, 1.0])
    wanted = place.position + (1.5 - arc.distance(place)) * ahead / (ahead @ SLANTED)
    assert arc.predicted(place, 1.5) == pytest.approx(wanted, rel=1e-12)
    stuck = parabola(matrix=lambda p: np.eye(2))
    lost = arc_of(stuck, 0.5, SLANTED)
    place = on(lost, 0.6)
    wanted = place.position + (1.5 - lost.distance(place)) * SLANTED
    assert lost.predicted(place, 1.5) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("direction", [ALONG, SLANTED])
def test_the_orbit_at_a_distance_is_found(direction: np.ndarray) -> None:
    arc = arc_of(parabola(), 0.5, direction)
    value = 0.5 + 0.3 / float(np.array([0.0, 3.0, 1.0]) @ direction)
    found = arc.at(0.3, np.array([0.1, 1.0, 0.45]))
    assert found is not None
    assert found.position == pytest.approx([value**2, 3.0 * value, value], rel=1e-12)
    between = arc.between(0.3, on(arc, 0.5), on(arc, 0.9))
    assert between is not None
    assert between.position == pytest.approx(found.position, rel=1e-12)


class Half(Arc):
    """An arc on which an orbit is found from near guesses alone."""

    def at(self, distance: float, guess: np.ndarray) -> Place | None:
        found = super().at(distance, guess)
        return found if found is not None and abs(found.position - guess).max() < 1e-3 else None


@pytest.mark.parametrize(("value", "good"), [(0.51, True), (0.89, True), (0.7, False)])
def test_where_the_chord_does_not_lead_to_an_orbit_the_tangents_of_both_ends_do(
    value: float, good: bool
) -> None:
    # The chord is 0.04 off at 0.7, and 4e-3 at 0.51; the tangents 1e-4 next to their ends.
    plain = arc_of(parabola(), 0.5)
    arc = Half(plain.problem, plain.origin, plain.direction)
    left, right = on(arc, 0.5), on(arc, 0.9)
    sharp = Half(arc.problem, arc.origin, arc.direction)
    found = sharp.between(value - 0.5, left, right)
    assert (found is not None) == good
    if found is not None:
        assert found.position[-1] == pytest.approx(value, rel=1e-12)
    else:
        with pytest.raises(LostError):
            sharp.smooth(value - 0.5, left, right)


def test_an_orbit_is_sought_by_the_chord_then_from_the_left_then_from_the_right() -> None:
    guesses = []

    class Nowhere(Arc):
        def at(self, distance: float, guess: np.ndarray) -> Place | None:
            guesses.append(guess.tolist())
            return None

    plain = arc_of(parabola(), 0.5)
    arc = Nowhere(plain.problem, plain.origin, plain.direction)
    left, right = on(arc, 0.6), on(arc, 0.9)
    assert arc.between(0.2, left, right) is None
    # At 0.7: a third of the chord from 0.6 to 0.9, and the tangents (1.2, 3, 1) and (1.8, 3, 1).
    chord = [0.36 + (0.81 - 0.36) / 3.0, 2.1, 0.7]
    wanted = [chord, [0.36 + 0.12, 2.1, 0.7], [0.81 - 0.36, 2.1, 0.7]]
    assert guesses == [pytest.approx(each, rel=1e-12) for each in wanted]


def test_a_root_is_narrowed_between_the_nearest_orbits_that_are_known() -> None:
    asked = []

    class Watched(Arc):
        def smooth(self, distance: float, left: Place, right: Place) -> Place:
            asked.append((distance, self.distance(left), self.distance(right)))
            return super().smooth(distance, left, right)

    plain = arc_of(parabola(), 0.5)
    arc = Watched(plain.problem, plain.origin, plain.direction)
    arc.root(lambda place: place.position[2] ** 5 - 0.1, on(arc, 0.5), on(arc, 0.9))
    known = [0.0, 0.4]
    assert len(asked) > 4
    for distance, left, right in asked:
        assert left == pytest.approx(max(each for each in known if each < distance), abs=1e-12)
        assert right == pytest.approx(min(each for each in known if each > distance), abs=1e-12)
        known.append(distance)


def test_an_orbit_of_other_phases_is_not_on_the_smooth_curve() -> None:
    touching = parabola(signature=lambda p: {("stop", Phase.UPPER): int(p > 0.7)})
    arc = arc_of(touching, 0.5)
    assert arc.smooth(0.15, on(arc, 0.5), on(arc, 0.9)).position[-1] == pytest.approx(0.65, rel=1e-14)
    with pytest.raises(LostError):
        arc.smooth(0.25, on(arc, 0.5), on(arc, 0.9))


def test_a_root_is_found_to_rounding_and_both_ways() -> None:
    arc = arc_of(parabola(), 0.5, SLANTED)
    for ends in ((0.5, 0.9), (0.9, 0.5)):
        root = arc.root(lambda place: place.position[0] - 0.5, on(arc, ends[0]), on(arc, ends[1]))
        assert root.position == pytest.approx([0.5, 3.0 * math.sqrt(0.5), math.sqrt(0.5)], rel=1e-13)


def test_a_root_between_curves_that_jump_is_lost() -> None:
    step = OnCurve(lambda p: np.array([float(p > 0.6), 0.0]), lambda p: np.zeros(2))
    arc = arc_of(step, 0.5)
    with pytest.raises(LostError):
        arc.root(lambda place: place.position[0] - 0.5, on(arc, 0.5), on(arc, 0.9))


def test_neighbours_may_be_as_far_apart_as_a_curve_four_times_as_steep_as_the_chord() -> None:
    map = parabola()
    problem = Problem(map, 1.0, np.ones(2))
    arc = Arc(problem, np.zeros(3), ALONG)

    def there(x: float, value: float) -> Place:
        return Place(problem, np.array([x, 0.0, value]), map.passage(value, np.array([x, 0.0])))

    # The chord is 5 long over 4 of the value; a piece over 0.1 may be 4 * 1.25 * 0.1 = 0.5 long.
    first, last = there(0.0, 0.0), there(3.0, 4.0)
    arc._check_joined([first, there(0.48, 0.1), last])
    with pytest.raises(LostError):
        arc._check_joined([first, there(0.51, 0.1), last])
    with pytest.raises(LostError):
        arc._check_joined([first, there(2.49, 3.9), last])
    assert arc._steepness(first, last) == pytest.approx(1.25, rel=1e-15)
