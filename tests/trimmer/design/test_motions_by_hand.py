"""Which motions of neighbours are new, with maps and orbits made by hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import motion, oscillator, output
from trimmer import MotionKind, SerialRunner
from trimmer.design import motions as module
from trimmer.design.found_motion import FoundMotion
from trimmer.design.motions import Motions, _around, _new, _same, motions_from_starts, with_neighbours
from trimmer.design.settings import DesignSettings
from trimmer.design.varied_places import Role, Varied
from trimmer.errors import TrimmerError
from trimmer.maps.cells import CellMotion, CellResult

SPEED = Varied(Role.SPEED, "frequency", "", "Hz", 20.0, 10.0, 30.0)
FORCE = Varied(Role.FRICTION, "frictions.blade.force", "blade", "N", 0.5, 0.0, 2.0)


def moving(size: float, mean: float = 0.0, **changes: Any) -> FoundMotion:
    made = replace(output(0.0, size), mean=mean)
    return motion(outputs={"x": output(0.0, 1.0), "y": made}, **changes)


def test_neighbours_lie_evenly_around_the_number_of_the_file() -> None:
    assert _around(SPEED, 7) == pytest.approx((14.0, 16.0, 18.0, 20.0, 22.0, 24.0, 26.0))
    assert _around(SPEED, 7)[3] == 20.0
    assert all(_around(SPEED, count)[count // 2] == 20.0 for count in range(3, 99, 2))
    assert _around(FORCE, 3) == pytest.approx((0.35, 0.5, 0.65))


def test_a_bound_draws_the_larger_neighbours_in() -> None:
    near = replace(FORCE, highest=0.575, bounded=True)
    assert _around(near, 5) == pytest.approx((0.35, 0.425, 0.5, 0.5375, 0.575))
    assert _around(replace(near, highest=0.5), 5) == pytest.approx((0.35, 0.425, 0.5))
    assert _around(replace(near, highest=5.0), 5) == pytest.approx((0.35, 0.425, 0.5, 0.575, 0.65))


def test_two_orbits_are_one_if_period_sizes_and_means_agree() -> None:
    one = moving(2.0, 0.1)
    assert _same(one, moving(2.0 + 1.9e-6, 0.1 - 1.9e-6))
    assert not _same(one, moving(2.0 + 2.1e-6, 0.1))
    assert not _same(one, moving(2.0 - 2.1e-6, 0.1))
    assert not _same(one, moving(2.0, 0.1 + 2.1e-6))
    assert not _same(one, moving(2.0, -0.1))
    assert not _same(one, moving(2.0, 0.1, period_count=2))


def test_the_first_motion_is_that_of_the_first_start() -> None:
    one, two = moving(1.0), moving(2.0)
    assert Motions((one, two), 3, 0, 0, "", False).first is one
    assert Motions((one, two), 3, 0, 1, "", True).first is None
    assert Motions((), 3, 0, 0, "", False).first is None


def answering(orbits: dict[float, FoundMotion | None], **properties: bool) -> Callable[..., Any]:
    """Return what solves for an orbit whose first state says which one it is."""
    usual = {"success": True, "stable": True, "neutral": False, **properties}

    def solve(mechanism: object, period_count: int, state: Any) -> Any:
        found = orbits[float(state[0])]
        if found is None:
            raise TrimmerError("none")
        return SimpleNamespace(**usual, motion=replace(found, period_count=period_count))

    return solve


def cell(*states: float, kind: MotionKind = MotionKind.PERIODIC, period_count: int = 1) -> list[CellMotion]:
    return [CellMotion(kind, period_count, states=((each, 0.0), (9.0, 9.0))) for each in states]


@pytest.fixture
def orbits(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    def use(known: dict[float, FoundMotion | None], **properties: bool) -> None:
        monkeypatch.setattr(module, "mechanism_orbit", answering(known, **properties))
        monkeypatch.setattr(module, "of_orbit", lambda orbit: orbit.motion)

    return use


def test_only_orbits_that_are_not_known_are_new(orbits: Callable[..., None]) -> None:
    orbits({1.0: moving(1.0), 2.0: None, 3.0: moving(3.0), 4.0: moving(3.0), 5.0: moving(5.0)})
    chaos = replace(moving(5.0), kind=MotionKind.CHAOTIC)
    known = Motions((moving(1.0), chaos), 3, 0, 0, "", False)
    cells = (
        *cell(7.0, kind=MotionKind.CHAOTIC),
        *cell(1.0, 2.0, 3.0, 4.0),
        *cell(5.0),
        *cell(1.0, period_count=2),
    )
    found = list(_new(oscillator(), tuple(cells), known))
    assert [(each.outputs["y"].peak_to_peak, each.period_count) for each in found] == [
        (3.0, 1),
        (5.0, 1),
        (1.0, 2),
    ]


def test_an_orbit_is_known_within_a_millionth_of_its_own_size(orbits: Callable[..., None]) -> None:
    orbits({1.0: moving(1.0 + 1.0000005e-6), 2.0: moving(1.0 - 1.0000005e-6)})
    known = Motions((moving(1.0),), 3, 0, 0, "", False)
    assert not list(_new(oscillator(), tuple(cell(1.0)), known))
    assert len(list(_new(oscillator(), tuple(cell(2.0)), known))) == 1


@pytest.mark.parametrize(
    ("properties", "count"),
    [
        ({"success": False}, 0),
        ({"stable": False}, 0),
        ({"stable": False, "neutral": True}, 1),
        ({"stable": True, "neutral": False}, 1),
    ],
)
def test_orbits_that_disturbances_leave_are_no_motions(
    orbits: Callable[..., None], properties: dict[str, bool], count: int
) -> None:
    orbits({1.0: moving(1.0)}, **properties)
    assert len(list(_new(oscillator(), tuple(cell(1.0)), Motions((), 1, 0, 0, "", False)))) == count


def test_the_cell_of_the_file_is_the_one_that_is_looked_at(
    orbits: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    orbits({float(number): moving(1.0 + number) for number in range(40)})
    settings, runner = DesignSettings(neighbours=5, cell_periods=44), SerialRunner()
    bounded = replace(FORCE, highest=0.5, bounded=True)  # three values instead of five
    asked: list[Any] = []

    def made(mechanism: object, values: dict[str, Any], **options: Any) -> Any:
        asked.append((values, options))
        cells = [CellResult(number, tuple(cell(float(number)))) for number in range(15)]
        return SimpleNamespace(cells=cells)

    def coexisting(result: Any, **options: Any) -> Any:
        asked.append(options)
        return SimpleNamespace(result=result, tried=31, rounds=4, complete=False)

    monkeypatch.setattr(module, "motion_map", made)
    monkeypatch.setattr(module, "coexisting_motions", coexisting)
    before = Motions((moving(0.1),), 6, 7, 2, "told", True)
    found = with_neighbours(oscillator(), before, (bounded, SPEED, SPEED), settings, runner)
    (values, options), more = asked
    assert list(values) == ["frictions.blade.force", "frequency"]
    assert values["frequency"] == pytest.approx((14.0, 17.0, 20.0, 23.0, 26.0))
    assert values["frictions.blade.force"] == pytest.approx((0.35, 0.425, 0.5))
    assert (options["most_periods"], options["runner"], more["runner"]) == (44, runner, runner)
    # Third row of rows of three, of these the third.
    assert [each.outputs["y"].peak_to_peak for each in found.found] == [0.1, 9.0]
    assert (found.starts, found.seed, found.lost, found.message, found.first_failed) == (
        6,
        7,
        2,
        "told",
        True,
    )
    near = found.neighbours
    assert near is not None
    assert near.places == ("frictions.blade.force", "frequency")
    assert (near.cells, near.reach, near.tried, near.rounds) == (15, 0.3, 31, 4)
    assert (near.complete, near.found) == (False, 1)


def test_without_two_sizes_no_neighbours_are_looked_at() -> None:
    alone = Motions((moving(1.0),), 1, 0, 0, "", False)
    settings, runner = DesignSettings(), SerialRunner()
    assert with_neighbours(oscillator(), alone, (SPEED,), settings, runner) is alone
    nothing = replace(FORCE, value=0.0)
    assert with_neighbours(oscillator(), alone, (SPEED, nothing), settings, runner) is alone


def test_starts_are_counted_and_their_message_kept() -> None:
    found = motions_from_starts(oscillator(), DesignSettings(starts=3, seed=5, most_periods=100))
    assert (found.starts, found.seed, found.lost, found.first_failed) == (3, 5, 0, False)
    assert (len(found.found), found.found[0].starts) == (1, 3)
    assert found.message
    assert found.neighbours is None
    assert found.found[0].state.shape == np.zeros(2).shape


def test_motions_that_cannot_be_measured_are_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    made = SimpleNamespace(motions=(1, 2, 3), motion=SimpleNamespace(message="told"))
    asked: list[Any] = []

    def respond(mechanism: object, **options: Any) -> Any:
        asked.append(options)
        return made

    monkeypatch.setattr(module, "respond", respond)
    monkeypatch.setattr(module, "of_settled", lambda each: None if each == 1 else moving(float(each)))
    found = motions_from_starts(oscillator(), DesignSettings(starts=3, seed=5, most_periods=100))
    assert asked == [{"starts": 3, "seed": 5, "most_periods": 100}]
    assert (found.lost, found.first_failed, len(found.found), found.message) == (1, True, 2, "told")
    monkeypatch.setattr(module, "of_settled", lambda each: None if each == 3 else moving(float(each)))
    free: Any = SimpleNamespace(frequency=None)
    found = motions_from_starts(free, DesignSettings(starts=3))
    assert asked[-1]["starts"] == 1
    assert (found.lost, found.first_failed, found.starts) == (1, False, 1)
