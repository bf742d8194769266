"""Corners of branches, at which they are passed or turn around, on maps whose orbits are known."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import line_front
from tests.trimmer.branches.maps import Bent, Failing, Given
from trimmer.branches import corner
from trimmer.branches.arc import Arc
from trimmer.branches.borders import Border
from trimmer.branches.corner import _first_behind, _step, _tangents, turned
from trimmer.branches.orbit import Place
from trimmer.branches.special import SpecialKind, SpecialPoint


def test_a_corner_is_passed_or_turned_at() -> None:
    # Beyond x = 0 the fixed points are p / (1 - slope): behind, if the slope is above 1.
    for slope, ahead in ((-0.5, 1.0), (2.0, -1.0)):
        front = line_front(Bent(0.5, slope), -1e-11, -2e-11)
        made = turned(front)
        assert made is not None
        wanted = np.array([ahead / (1.0 - slope), ahead])
        assert made.front.tangent == pytest.approx(wanted / np.linalg.norm(wanted), rel=1e-9)
        kinds = [point.kind for point in made.special]
        assert kinds == [SpecialKind.GRAZING, SpecialKind.FOLD][: 1 + (ahead < 0.0)]
        old = np.array([2.0, 1.0]) / math.sqrt(5.0)
        assert made.bend == pytest.approx(math.acos(made.front.tangent @ old), rel=1e-6)
        assert made.switches == ()
        assert 0.0 < abs(made.front.place.position[1]) < 1e-9
    assert turned(line_front(Bent(0.5, 2.0), -0.5, -1.0)) is None
    assert turned(line_front(Failing(), 0.5 - 1e-12, 1.0)) is None


def test_behind_a_corner_the_direction_with_the_same_turn_comes_first() -> None:
    front = line_front(Bent(0.5, 2.0), -1e-11, -2e-11)
    beyond = front.problem.place(np.array([1e-9, 1e-9]))
    assert beyond is not None
    first, second = _tangents(front, beyond)
    assert np.sign(beyond.orientation(first)) == front.turn
    assert first.tolist() == (-second).tolist()
    other = _tangents(replace(front, turn=-front.turn), beyond)
    assert other[0].tolist() == second.tolist()
    either = _tangents(replace(front, turn=0.0), beyond)
    assert either[0].tolist() == (-either[1]).tolist()
    assert abs(either[0]) == pytest.approx(abs(first), rel=1e-15)


def test_the_other_side_of_a_border_is_looked_for_close_beyond_the_front() -> None:
    asked = []

    @dataclass(frozen=True)
    class Watched(Bent):
        def passage(self, value: float, state: np.ndarray) -> Given:
            asked.append(np.array([state[0], value]))
            return super().passage(value, state)

    front = line_front(Watched(0.5, 2.0), -0.5, -1.0)
    asked.clear()
    assert turned(front) is None
    tangent = np.array([2.0, 1.0]) / math.sqrt(5.0)
    away = [(each - [-1.0, -0.5]) for each in asked]
    assert np.array(away) == pytest.approx(np.outer(10.0 ** np.arange(-10.0, -5.0), tangent), abs=1e-15)


def test_the_direction_behind_a_corner_is_the_null_vector_there() -> None:
    along = np.array([2.0, -3.0, 6.0]) / 7.0
    slope = np.array([[3.0, 2.0, 0.0], [0.0, 4.0, 2.0]])
    beyond = SimpleNamespace(slope=slope, orientation=lambda tangent: float(tangent[2]))
    for turn in (1.0, -1.0):
        first, second = _tangents(SimpleNamespace(turn=turn), beyond)  # type: ignore[arg-type]
        assert first == pytest.approx(turn * along, rel=1e-12)
        assert second.tolist() == (-first).tolist()


@dataclass(frozen=True)
class Shifted(Bent):
    """As ``Bent``, with the corner at x = 3 and p = 2."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        found = super().passage(value - 2.0, state - 3.0)
        return replace(found, end=found.end + 3.0)


def test_the_orbit_behind_a_corner_is_near_and_has_other_phases(monkeypatch: pytest.MonkeyPatch) -> None:
    # Behind it the orbits are x = 3 + p / 1.5; a direction that leads along them by 1/29 finds one.
    front = line_front(Shifted(0.5, -0.5), 2.0 - 1e-12, 3.0 - 2e-12)
    along, aside = np.array([2.0, 3.0]) / math.sqrt(13.0), np.array([3.0, -2.0]) / math.sqrt(13.0)
    guesses = []

    class Guessed(Arc):
        def at(self, distance: float, guess: np.ndarray) -> Place | None:
            guesses.append(guess - front.place.position)
            return super().at(distance, guess)

    monkeypatch.setattr(corner, "Arc", Guessed)

    def found(share: float, sign: float = 1.0) -> Place | None:
        direction = sign * (share * along + math.sqrt(1.0 - share * share) * aside)
        place = _first_behind(front, direction, 1e-7)
        assert guesses[-1] == pytest.approx(1e-7 * direction, rel=1e-6)
        return place

    for share in (1.0, 1.0 / 29.0):
        place = found(share)
        assert place is not None
        assert place.position - [3.0, 2.0] == pytest.approx(1e-7 / share * along, rel=1e-4)
    assert found(1.0 / 31.0) is None
    # The other way it is one with the same phases.
    assert found(1.0, -1.0) is None


@pytest.mark.parametrize(
    ("old", "new", "folds"),
    [(0.8, 0.6, False), (0.8, -0.6, True), (-0.8, 0.6, True), (0.0, -0.6, False), (-0.8, 0.0, False)],
)
def test_a_corner_is_a_fold_if_the_value_turns_around(
    monkeypatch: pytest.MonkeyPatch, old: float, new: float, folds: bool
) -> None:
    before, after = (
        np.array([*(0.0, math.sqrt(1.0 - at * at))[::way], at]) for at, way in ((old, -1), (new, 1))
    )
    place = SimpleNamespace(tangent=lambda reference: after if reference is before else None)
    point = SpecialPoint(SpecialKind.STICK, 2.0, np.zeros(2))
    asked = []

    def points(border: Border) -> list[SpecialPoint]:
        asked.append((border.before, border.after))
        return [point]

    monkeypatch.setattr(corner, "special_points", points)
    moved = SimpleNamespace(position="here")
    front = SimpleNamespace(problem="orbits", place=moved, tangent=before, moved=lambda *given: given)
    made = _step(front, place, before)  # type: ignore[arg-type]
    assert made is not None
    assert asked == [(moved, place)]
    assert [each.kind for each in made.special] == [SpecialKind.STICK, SpecialKind.FOLD][: 1 + folds]
    assert made.front == (place, after)  # type: ignore[comparison-overlap]
    assert made.bend == pytest.approx(math.acos(old * new), rel=1e-12)
    assert _step(front, place, after) is None  # type: ignore[arg-type]
    monkeypatch.setattr(corner, "special_points", lambda border: [])
    nothing = _step(front, place, before)  # type: ignore[arg-type]
    assert nothing is not None
    assert nothing.special == ()
