"""What a locus is searched with: ranges, distances to a special point, guesses, and what is told."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.trimmer import results
from tests.trimmer.branches.curves import parabola
from tests.trimmer.branches.maps import Henon
from trimmer.branches.loci.follow_special import _distance, _message, _ranges_of
from trimmer.branches.loci.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.loci.relocation import Sought, _centre, relocated
from trimmer.branches.loci.search import Search, Track
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MechanismError


def test_settings_and_ranges_out_of_bounds_are_refused() -> None:
    for wrong in ({"most_points": 1}, {"largest_step": 1.5}, {"smallest_step": 0.04}, {"smallest_step": 0.0}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            LocusSettings(**wrong)  # type: ignore[arg-type]
    assert LocusSettings(2, 1.0, 1.0).smallest_step == 1.0
    assert not LocusSettings().quiet
    with pytest.raises(ValueError, match="second must be a lower"):
        LocusRanges((0.0, 1.0), (2.0, 2.0))
    ranges = LocusRanges((-1.0, 3.0), (2e-5, 6e-5))
    search = Search(None, None, ranges)  # type: ignore[arg-type]
    assert search.spans == pytest.approx([4.0, 4e-5], rel=1e-12)
    assert search.lowest.tolist() == [-1.0, 2e-5]
    assert search.inside(np.array([0.0, 1.0]))
    for values in ([-1e-9, 0.5], [0.5, 1.0 + 1e-9], [1.1, 0.5], [0.5, -0.1]):
        assert not search.inside(np.array(values))


def test_ranges_hold_the_points_of_the_branch_and_the_way_to_go() -> None:
    branch = SimpleNamespace(points=[SimpleNamespace(value=value) for value in (3.0, 7.0, 4.0)])
    special = SpecialPoint(SpecialKind.FOLD, 8.0, np.zeros(1))
    assert _ranges_of(branch, special, 5e-5, 2e-5).both == ((3.0, 8.0), (2e-5, 5e-5))  # type: ignore[arg-type]
    inner = SpecialPoint(SpecialKind.FOLD, 5.0, np.zeros(1))
    assert _ranges_of(branch, inner, 2e-5, 5e-5).both == ((3.0, 7.0), (2e-5, 5e-5))  # type: ignore[arg-type]


TURN = np.exp(0.7j)


@pytest.mark.parametrize(
    ("kind", "mirrored", "distance"),
    [
        (SpecialKind.FOLD, False, 0.25),
        (SpecialKind.FOLD, True, 0.25),
        (SpecialKind.PERIOD_DOUBLING, False, 0.125),
        (SpecialKind.SYMMETRY_BREAKING, False, 0.25),
        (SpecialKind.SYMMETRY_BREAKING, True, 0.125),
        (SpecialKind.TORUS, False, 0.0625),
        (SpecialKind.GRAZING, False, math.nan),
        (SpecialKind.STICK, False, math.nan),
    ],
)
def test_the_distance_is_of_the_multiplier_that_the_kind_speaks_of(
    kind: SpecialKind, mirrored: bool, distance: float
) -> None:
    multipliers = np.array([1.25, -1.125, 0.9375 * TURN, 0.9375 / TURN, 0.3 * TURN, 0.3 / TURN])
    search = SimpleNamespace(sought=Sought(kind, ()), maps=(SimpleNamespace(mirrored=mirrored),))
    place = SimpleNamespace(multipliers=multipliers)
    assert _distance(search, place) == pytest.approx(distance, rel=1e-12, nan_ok=True)  # type: ignore[arg-type]
    assert math.isnan(_distance(search, None))  # type: ignore[arg-type]
    real = SimpleNamespace(multipliers=np.array([0.9 + 0j, -0.5]))
    if kind is SpecialKind.TORUS:
        assert math.isnan(_distance(search, real))  # type: ignore[arg-type]


def test_the_message_names_what_is_beside_a_locus_that_changes() -> None:
    maps = (SimpleNamespace(place="frequency"), SimpleNamespace(place="plays.bridge.gap"))
    search = SimpleNamespace(maps=maps)
    kinds = (SpecialKind.TORUS, SpecialKind.STICK, SpecialKind.FOLD, SpecialKind.STICK, SpecialKind.GRAZING)
    track = Track([], [SpecialPoint(kind, 0.0, np.zeros(1)) for kind in kinds])
    numbers = np.array([110.0, 4e-5])
    at = "at frequency = 110 and plays.bridge.gap = 4e-05"
    changed = _message(search, track, LocusEnd.CHANGED, numbers)  # type: ignore[arg-type]
    assert changed == f"{LocusEnd.CHANGED.value}, {at}; beside it: fold, grazing, stick, torus"
    assert _message(search, track, LocusEnd.LOST, numbers) == f"{LocusEnd.LOST.value}, {at}"  # type: ignore[arg-type]


def test_a_fold_is_found_again_near_a_guess_and_nothing_else_is() -> None:
    # Hénon's fold is at a = -(1 - b)² / 4 and x = (1 - b) / (-2 a).
    fold, x = -0.1225, 0.7 / (2 * 0.1225)
    sought = Sought(SpecialKind.FOLD, ())
    guess = np.array([x + 0.01, 0.3 * x])
    found = relocated(Henon(), 0.5, sought, fold + 1e-4, guess, 0.05)
    assert found is not None
    assert found.point is not None
    assert found.point.value == pytest.approx(fold, rel=1e-11)
    assert found.point.state == pytest.approx([x, 0.3 * x], rel=1e-5)
    assert found.others == ()
    assert found.problem.span == 0.5
    assert found.problem.sizes == pytest.approx(abs(guess))
    doubling = relocated(Henon(), 0.5, Sought(SpecialKind.PERIOD_DOUBLING, ()), fold + 1e-4, guess, 0.05)
    assert doubling is not None
    assert doubling.point is None
    assert [each.kind for each in doubling.others] == [SpecialKind.FOLD]
    assert doubling.others[0].value == pytest.approx(fold, rel=1e-11)
    # Away from it the piece ends before it: nothing is there.
    away = relocated(Henon(), 0.5, sought, 0.1, np.array([0.9, 0.27]), 1e-3)
    assert away is not None
    assert (away.point, away.others) == (None, ())
    assert relocated(Henon(), 0.5, sought, -3.0, np.array([5.0, 1.0]), 1e-3) is None
    assert relocated(Henon(), 0.5, sought, 0.1, np.array([np.nan, 0.27]), 1e-3) is None


def test_what_is_sought_has_its_kind_and_parts() -> None:
    sought = Sought(SpecialKind.GRAZING, ("stop",))
    assert sought.fits(SpecialPoint(SpecialKind.GRAZING, 0.0, np.zeros(1), ("stop",)))
    assert not sought.fits(SpecialPoint(SpecialKind.GRAZING, 0.0, np.zeros(1), ("play",)))
    assert not sought.fits(SpecialPoint(SpecialKind.STICK, 0.0, np.zeros(1), ("stop",)))


def test_the_middle_of_a_piece_is_the_orbit_beside_the_guess() -> None:
    map = parabola()
    exact = map.at(0.5)
    tangent = np.array([1.0, 3.0, 1.0]) / math.sqrt(11.0)
    aside = np.array([3.0, -1.0, 0.0]) / math.sqrt(10.0)
    guess = exact.problem.place(exact.position + 1e-4 * aside)
    assert guess is not None
    centre = _centre(guess)
    assert centre is not None
    assert centre.position == pytest.approx(exact.position, abs=1e-7)
    assert abs(tangent @ (centre.position - guess.position)) < 1e-7


def test_a_locus_tells_its_points() -> None:
    locus = results.locus()
    assert locus.first.tolist() == [1.0, 1.2, 1.4]
    assert locus.second.tolist() == [8e-6, 9e-6, 12e-6]
    assert locus.success
    assert locus.name == "fold"
    assert "fold over frequency and stops.wall.gap, 3 points" in str(locus)
    table = locus._table()
    rows = [list(row) for row in table.rows()]
    assert rows == [[*locus.values[number], 0.0, 0.0] for number in range(3)]
    assert [(column.name, column.unit) for column in table.columns] == [
        ("frequency", "Hz"),
        ("stops.wall.gap", "m"),
        ("residual", ""),
        ("distance", ""),
    ]
    both = Locus(
        SpecialKind.STICK,
        ("a", "b"),
        *[
            getattr(locus, name)
            for name in ("places", "periods", "values", "states", "residual", "distance", "reason", "message")
        ],
    )
    assert both.name == "stick, a and b"
    assert both.units == ("", "")
    assert both.plot(Figure().add_subplot()).get_xlabel() == "frequency"
    ends = {each for each in LocusEnd if each.is_success}
    assert ends == {LocusEnd.LEFT, LocusEnd.CLOSED}


def test_a_value_that_a_number_cannot_have_ends_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    from trimmer.branches.loci.search import found_again

    search = Search((None, None), None, LocusRanges((0.0, 1.0), (0.0, 2.0)))  # type: ignore[arg-type]

    def refused(self: Search, held: int, value: float, share: float | None) -> None:
        assert (held, value, share) == (1, 1.0, None)
        raise MechanismError("it cannot have that value")

    monkeypatch.setattr(Search, "map_at", refused)
    values = np.array([0.25, 0.5])
    assert found_again(search, Track([]), 1, values, np.zeros(2), 0.1) is None
