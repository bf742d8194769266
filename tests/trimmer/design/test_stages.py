"""Which stages a study of a design has, with stages that only say what they were asked."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from tests.trimmer.design.made import motion, oscillator
from trimmer import MotionKind
from trimmer.design import design as module
from trimmer.design.design import Stage, Study
from trimmer.design.design_file import DesignFile, OpenRange
from trimmer.design.found_motion import FoundMotion
from trimmer.design.keeping import Keeper
from trimmer.design.motions import Motions
from trimmer.design.settings import DesignSettings
from trimmer.design.targets import Measure, Target
from trimmer.design.varied_places import Role, Varied

TARGET = Target("stroke_at_least", Measure.STROKE, "block", 1.0)
RANGE = OpenRange("frequency", "Hz", 19.0, 21.0, False)
GAP = Varied(Role.GAP, "stops.stop.gap", "stop", "m", 4e-5, 0.0, 1.6e-4)
SPEED = Varied(Role.SPEED, "frequency", "", "Hz", 20.0, 10.0, 30.0)
FRICTION = Varied(Role.FRICTION, "frictions.blade.force", "blade", "N", 0.5, 0.0, 2.0)
SETTINGS = DesignSettings(starts=2, seed=5, most_periods=33, most_points=44, cells=24)


class Kept(Keeper):
    """Makes each stage, and notes what it depends on and what is told."""

    def __init__(self) -> None:
        super().__init__()
        object.__setattr__(self, "notes", [])
        object.__setattr__(self, "told", [])

    notes: list[tuple[str, Any]]
    told: list[tuple[Stage, str, int, int]]

    def made(self, stage: str, depends: object, make: Any) -> Any:
        self.notes.append((stage, depends))
        return make()


@pytest.fixture(autouse=True)
def stages(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let each stage return its name and what it was given."""
    for name in (
        "linear_states",
        "with_neighbours",
        "spectra",
        "path_through",
        "sensitivities",
        "study_ranges",
        "remedies",
        "questions",
    ):
        monkeypatch.setattr(module, name, lambda *given, name=name: (name, *given))
    monkeypatch.setattr(module, "design_map", lambda *given: ("map", *given))


def study(**changes: Any) -> Any:
    fields: dict[str, Any] = {"ranges": (RANGE,), "targets": (TARGET,), "mechanism": oscillator(), **changes}
    file = DesignFile("mine.toml", fields["mechanism"], fields["targets"], None, fields["ranges"], {})
    runner: Any = "runner"
    keeper = Kept()
    return Study(file, SETTINGS, runner, keeper, lambda *each: keeper.told.append(each))


def motions(*found: FoundMotion, failed: bool = False) -> Motions:
    return Motions(found, 2, 5, 0, "", failed)


def free() -> Any:
    return replace(oscillator(), frequency=None, forces={})


def test_the_linear_stage_is_told_before_and_after() -> None:
    made = study()
    assert made.linear() == ("linear_states", made.file.mechanism)
    assert made.keeper.told == [(Stage.LINEAR, (), 0, 1), (Stage.LINEAR, (), 1, 1)]
    assert made.keeper.notes == [("linear", ((), ()))]


@pytest.mark.parametrize(("varied", "near"), [((GAP, SPEED), True), ((SPEED,), False), ((), False)])
def test_neighbours_need_two_numbers(
    monkeypatch: pytest.MonkeyPatch, varied: tuple[Varied, ...], near: bool
) -> None:
    found = motions(motion())
    monkeypatch.setattr(module, "motions_from_starts", lambda mechanism, settings: found)
    monkeypatch.setattr(module, "varied_places", lambda mechanism, first: varied)
    made = study()
    if near:
        settings = SETTINGS.without_cells
        assert made.motions() == ("with_neighbours", made.file.mechanism, found, varied, SETTINGS, "runner")
        assert made.keeper.notes == [("motions", ((), (2, 5, 33))), ("neighbours", ((), settings))]
        assert settings == replace(SETTINGS, cells=0)
    else:
        assert made.motions() is found
    assert study(mechanism=free()).motions() is found


def test_motions_that_do_not_repeat_have_no_slopes_and_no_branches() -> None:
    made, repeating = study(), motion()
    assert made.sensitivities(motions(repeating)) == ("sensitivities", made.file.mechanism, repeating)
    assert made.sensitivities(motions(repeating, failed=True)) is None
    chaos = motion(kind=MotionKind.CHAOTIC)
    assert made.sensitivities(motions(chaos)) is None
    assert made.paths(motions(chaos), (GAP,)) == ()
    assert made.paths(motions(repeating, failed=True), (GAP,)) == ()
    assert made.paths(motions(motion(neutral=True)), (GAP,)) == ()
    assert study(mechanism=free()).paths(motions(repeating), (GAP,)) == ()
    made.keeper.notes.clear()
    paths = made.paths(motions(repeating), (GAP, SPEED))
    assert paths == tuple(("path_through", made.file.mechanism, each, repeating, 44) for each in (GAP, SPEED))
    assert made.keeper.notes == [
        ("branch", (("stops.stop.gap",), (GAP, 44))),
        ("branch", (("frequency",), (SPEED, 44))),
    ]


def test_spectra_are_of_the_first_motion() -> None:
    made, first = study(), motion()
    linear: Any = ("linear",)
    assert made.spectra(motions(first), linear) == ("spectra", first, 20.0, linear)
    assert made.spectra(motions(first, failed=True), linear) == {}


def test_ranges_need_a_drive_and_something_unknown() -> None:
    made = study()
    given = (made.file.mechanism, (RANGE,), (TARGET,), SETTINGS, "runner")
    assert made.ranges() == ("study_ranges", *given)
    assert made.keeper.notes == [("ranges", ((), ((RANGE,), (TARGET,), 17, 300)))]
    assert study(ranges=()).ranges() is None
    assert study(mechanism=free()).ranges() is None


def test_remedies_need_a_drive_and_a_miss() -> None:
    made, of = study(), ("slopes",)
    missed: Any = SimpleNamespace(missed=(TARGET,))
    given = (made.file.mechanism, (TARGET,), (TARGET,), of, SETTINGS, "runner")
    assert made.remedies(missed, of) == ("remedies", *given)
    assert made.keeper.notes == [("remedies", ((), ((TARGET,), SETTINGS.without_cells)))]
    assert made.remedies(SimpleNamespace(missed=()), None) is None
    assert study(mechanism=free()).remedies(missed, None) is None


@pytest.mark.parametrize(
    ("varied", "pairs"),
    [
        ((GAP, SPEED, FRICTION), [(GAP, SPEED), (GAP, FRICTION)]),
        ((SPEED, FRICTION), [(SPEED, FRICTION)]),
        ((SPEED,), []),
        ((), []),
    ],
)
def test_maps_are_over_the_first_number_and_each_other(varied: Any, pairs: Any) -> None:
    made = study()
    found = made.maps(varied)
    assert [each[2:4] for each in found] == pairs
    assert study(mechanism=free()).maps(varied) == ()
    for each in found:
        assert each[1] is made.file.mechanism
        assert each[4:7] == (SETTINGS, "runner", made.keeper)
        each[-1](3, 24)
        assert made.keeper.told[-1] == (Stage.MAP, (each[2].place, each[3].place), 3, 24)


def test_the_whole_and_the_short_look_hold_what_was_made(monkeypatch: pytest.MonkeyPatch) -> None:
    first = motion(outputs=motion().outputs | {"block": motion().outputs["stroke"]})
    monkeypatch.setattr(module, "motions_from_starts", lambda mechanism, settings: motions(first))
    monkeypatch.setattr(module, "varied_places", lambda mechanism, of: (SPEED,))
    made = study(ranges=())
    for design in (made.whole(), made.short()):
        assert (design.file, design.settings) == (made.file, SETTINGS)
        assert design.motion is first
        assert design.linear == ("linear_states", made.file.mechanism)
        assert design.varied == (SPEED,)
        assert design.spectra == ("spectra", first, 20.0, design.linear)
        assert design.verdict.missed == (TARGET,)
        assert design.questions == ("questions", made.file.mechanism, first)
        assert design.ranges is None
        assert design.maps == ()
    assert (design.paths, design.sensitivities, design.remedies) == ((), None, None)
    whole = made.whole()
    assert [each[0] for each in whole.paths] == ["path_through"]
    assert whole.sensitivities[0] == "sensitivities"
    assert whole.remedies[4] == whole.sensitivities
