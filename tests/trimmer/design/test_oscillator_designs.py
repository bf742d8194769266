"""Slopes, remedies, neighbours and stages of an oscillator whose motion is known in closed form."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.design.made import motion, oscillator, output
from trimmer import Mechanism, MotionKind, SerialRunner, WrongTypeError
from trimmer.deadline import NEVER
from trimmer.design import (
    DesignFile,
    DesignSettings,
    Elasticity,
    FoundMotion,
    Measure,
    MeasureOfPart,
    Motions,
    NumberRole,
    OpenRange,
    Remedies,
    Sensitivities,
    Sensitivity,
    Stage,
    Study,
    Target,
    VariedNumber,
    read_design_file,
)
from trimmer.design.motions import motions_from_starts, with_neighbours
from trimmer.design.parameter_studies.keeping import Keeper
from trimmer.design.parameter_studies.strongest import pairs_of_targets
from trimmer.design.trials.forecast import AMPLE, EFFORT
from trimmer.design.trials.remedies import Mend
from trimmer.design.trials.remedy_search import ALIKE, remedies
from trimmer.design.trials.sensitivity import designable, sensitivities
from trimmer.design.trials.surroundings import SPEEDS, Beside, conditions_of
from trimmer.design.varied_places import varied_places
from trimmer.mechanism import Body, Force, Friction, Link, Pin, Play, Stop
from trimmer.runners.timed import TimedRunner
from trimmer.uncertainty import Scatter, Uncertainty, Uniform

ENDS = ("ground", "block")
STROKE, DOUBLE = MeasureOfPart(Measure.STROKE, "block"), MeasureOfPart(Measure.STROKE, "double")
NUMBERS = {
    "frequency": 20.0,
    "bodies.block.mass": 0.5,
    "links.spring.stiffness": 9e3,
    "links.spring.damping": 4.0,
    "forces.shaker.amplitude": 7.0,
}
TARGET = Target("stroke_at_least", Measure.STROKE, "block", 0.02)
RUNNER = TimedRunner(SerialRunner(), NEVER)
FEW = DesignSettings(
    starts=2, seed=5, most_periods=300, cell_periods=200, trials=16, most_points=4, neighbours=3, grid=1
)
MANY = replace(FEW, machines=24)  # more than are looked at first


def stroke(**changes: float) -> float:
    """Return 2 F / |k - m w^2 + i c w|, m."""
    frequency, m, k, c, force = (NUMBERS | changes).values()
    omega = 2 * np.pi * frequency
    return float(2 * force / abs(k - m * omega**2 + 1j * c * omega))


@pytest.mark.parametrize("asked", [STROKE, DOUBLE])
def test_slopes_are_central_differences_of_the_formula(asked: MeasureOfPart) -> None:
    found = sensitivities(oscillator(), motion(state=np.zeros(2), period_count=1))
    assert (found.step, found.failed) == (1e-3, ())
    assert [each.place for each in found.entries] == list(NUMBERS)
    for each in found.entries:
        below, above = (stroke(**{each.place: each.value * (1 + sign * 5e-4)}) for sign in (-1, 1))
        slope = each.of(asked)
        assert slope is not None
        assert slope.value == pytest.approx((above - below) / (5e-4 * (above + below)), rel=1e-6)
        assert slope.smooth
    sizes = [abs(each.of(asked).value) for each in found.ranked(asked)]  # type: ignore[union-attr]
    assert sizes == sorted(sizes, reverse=True)


def test_numbers_that_are_zero_or_no_sizes_are_not_changed() -> None:
    made = Mechanism(
        bodies={"block": Body(0.5)},
        frequency=110.0,
        pins={"pin": Pin("ground", 1e-3, 0.3, 0.2, -0.1, 2)},
        links={"spring": Link(("pin", "block"), 2e3)},
        plays={"play": Play(ENDS, 3e3, 0.0, 4e-5)},
        frictions={"blade": Friction(ENDS, 0.5, 0.7)},
        forces={"push": Force("block", 0.0, 2.0, 0.1, 3)},
    )
    assert {place: unit for place, unit, _ in designable(made)} == {
        "frequency": "Hz",
        "bodies.block.mass": "kg",
        **{"pins.pin.amplitude": "m", "pins.pin.velocity": "m/s", "links.spring.stiffness": "N/m"},
        **{"plays.play.stiffness": "N/m", "plays.play.gap": "m"},
        **{"frictions.blade.force": "N", "frictions.blade.static": "N", "forces.push.amplitude": "N"},
    }
    assert all(value == made.value(place) for place, _, value in designable(made))


def searched(bound: float, *, scatter: float = 0.0) -> Remedies:
    """Return what meets a stroke, at neighbouring speeds and with a mass that scatters."""
    wanted = replace(TARGET, bound=bound)
    mass = Scatter("bodies.block.mass", "kg", Uniform(0.5 - scatter, 0.5 + scatter))
    conditions = conditions_of(oscillator(), Uncertainty((mass,)) if scatter else None, MANY)
    return remedies(oscillator(), (wanted,), (wanted,), None, conditions, FEW, RUNNER)


def worst(bound: float, shifts: tuple[float, ...] = (), **changes: float) -> float:
    """Return the smallest margin in the formula, at the point, at other speeds, and with other masses."""
    numbers = NUMBERS | changes
    under = [{"frequency": numbers["frequency"] * (1 + speed)} for speed in (0.0, *SPEEDS)]
    under += [{"bodies.block.mass": numbers["bodies.block.mass"] + shift} for shift in shifts]
    return min(min(stroke(**(changes | each)) / bound - 1, 1.0) for each in under)


def one(bound: float) -> float:
    """Return the largest margin that one number gives in the formula, by brute force."""
    factors = np.geomspace(1 / 3, 3, 400)
    ends = dict.fromkeys(NUMBERS, factors) | {"frequency": np.geomspace(1 / 1.5, 1.5, 400)}
    return max(worst(bound, **{place: NUMBERS[place] * at}) for place, those in ends.items() for at in those)


@pytest.mark.parametrize("scatter", quick([0.0, 0.01], 1))
def test_a_remedy_meets_its_target_beside_the_point_with_the_margin_that_the_formula_gives(
    scatter: float,
) -> None:
    found = searched(0.02, scatter=scatter)
    assert found.found and found.nearest is None and found.starts == FEW.remedy_starts
    for each in found.found:
        shifts = [dict(condition.shifts) for condition, _ in each.around.beside(Beside.SCATTER)]
        assert len(shifts) == (MANY.machines if scatter else 0)
        changes = {change.place: change.after for change in each.changes}
        masses = tuple(shift["bodies.block.mass"] for shift in shifts)
        assert each.margin == pytest.approx(worst(0.02, masses, **changes), rel=1e-6)
        assert each.margin >= 0 and each.meeting == FEW.remedy_starts
        assert all(float(f"{change.after:.3g}") == change.after for change in each.changes)


@pytest.mark.slow
def test_the_change_with_much_margin_stands_first() -> None:
    """By brute force in the formula no change of one number has more, up to what counts alike."""
    first, best = searched(0.018).found[0], one(0.018)
    assert best > 0.1 and min(first.margin, AMPLE) >= min(best, AMPLE) - ALIKE - EFFORT


@pytest.mark.slow
def test_two_numbers_do_what_one_cannot() -> None:
    bound = 0.0225
    assert one(bound) < 0
    found = searched(bound)
    assert found.found and all(len(each.changes) == 2 for each in found.found)
    never = searched(0.2)
    assert never.found == () and never.nearest is not None and never.nearest.margin < 0
    (mend,) = never.mends
    assert mend.change is None and mend.helpless == never.tried


def test_a_target_is_drawn_over_two_numbers_not_over_one_twice() -> None:
    mend = Mend(TARGET, None, np.nan, (), (), ("bodies.block.mass",))
    entries = tuple(
        Sensitivity(place, "", NUMBERS[place], (Elasticity(STROKE, slope, True),))
        for place, slope in (("bodies.block.mass", 3.0), ("links.spring.stiffness", 2.0), ("frequency", 1.0))
    )
    found = Remedies((), None, (mend,), 2, (), 0)
    (pair,) = pairs_of_targets(oscillator(), (TARGET,), (), Sensitivities(1e-3, entries, ()), found)
    assert [each.place for each in pair] == ["bodies.block.mass", "links.spring.stiffness"]


@pytest.mark.slow
def test_numbers_of_influence_are_tried_before_the_others() -> None:
    links = {f"l{number}": Link(ENDS, 1.0 + number) for number in range(20)}
    made = replace(oscillator(), links=links)
    never = replace(TARGET, bound=1e9)

    def tried(slopes: dict[int, float]) -> tuple[str, ...]:
        entries = tuple(
            Sensitivity(f"links.l{number}.stiffness", "N/m", 1.0, (Elasticity(STROKE, slope, True),))
            for number, slope in slopes.items()
        )
        few = replace(FEW, trials=1, cell_periods=2)
        of = Sensitivities(1e-3, entries, ())
        return remedies(made, (never,), (never,), of, (), few, RUNNER).tried

    assert tried({})[:3] == ("forces.shaker.amplitude", "frequency", "links.l0.stiffness")
    assert len(tried({})) == 16
    assert tried({3: 1.0, 15: -2.0})[:2] == ("links.l3.stiffness", "links.l15.stiffness")


@pytest.mark.parametrize(
    ("count", "told"),
    [
        (2, "neighbours must be odd, as the file's own value is the middle one, not 2; 3 would do"),
        (0, "neighbours must be a whole number from 1 on, not 0"),
    ],
)
def test_neighbours_around_no_middle_are_refused(count: int, told: str) -> None:
    with pytest.raises(ValueError, match=f"^{told}$"):
        DesignSettings(neighbours=count)


@pytest.mark.slow
def test_starts_are_counted_and_neighbours_are_looked_at_around_two_numbers() -> None:
    alone = motions_from_starts(oscillator(), replace(FEW, starts=3))
    assert (alone.starts, alone.seed, alone.lost, alone.first_failed) == (3, 5, 0, False)
    assert [each.starts for each in alone.found] == [3]
    assert alone.message and alone.neighbours is None
    speed, drive = (
        VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 20.0, 10.0, 30.0),
        VariedNumber(NumberRole.FRICTION, "forces.shaker.amplitude", "", "N", 7.0, 0.0, 7.0, True),
    )
    runner = SerialRunner()
    assert with_neighbours(oscillator(), alone, (speed,), FEW, runner) is alone
    assert with_neighbours(oscillator(), alone, (speed, replace(drive, value=0.0)), FEW, runner) is alone
    # A bound at the number itself leaves those below it alone: five by three cells.
    found = with_neighbours(oscillator(), alone, (speed, drive), replace(FEW, neighbours=5), runner)
    near = found.neighbours
    assert near is not None
    assert near.places == ("frequency", "forces.shaker.amplitude")
    assert (near.cells, near.reach, near.found) == (15, 0.3, 0)
    # Every cell has one orbit: what a neighbour leads to is known already.
    assert near.complete and found.found == alone.found
    unknown = Motions((), 3, 5, 1, "told", True)
    found = with_neighbours(oscillator(), unknown, (speed, drive), FEW, runner)
    assert [each.outputs["block"].peak_to_peak for each in found.found] == pytest.approx([stroke()])
    assert (found.lost, found.message, found.first_failed, found.first) == (1, "told", True, None)
    resonant = oscillator().with_value("links.spring.damping", 0.0)
    resonant = resonant.with_value("links.spring.stiffness", 0.5 * (2 * np.pi * 20.0) ** 2)
    found = with_neighbours(resonant, unknown, (speed, drive), replace(FEW, neighbours=1), runner)
    assert found.neighbours is not None and (found.found, found.neighbours.cells) == ((), 1)


class Noting(Keeper):
    """Keeps nothing, and notes the name of each stage that could be kept."""

    def __init__(self) -> None:
        super().__init__()
        object.__setattr__(self, "names", [])

    names: list[str]

    def keep(self, stage: str, depends: object, result: object) -> None:
        self.names.append(stage)


def study(
    mechanism: Mechanism, *ranges: OpenRange, targets: tuple[Target, ...] = (TARGET,)
) -> tuple[Study, list]:
    told: list[tuple[Stage, tuple[str, ...], int, int]] = []
    file = DesignFile("mine.toml", mechanism, targets, None, ranges, {})
    settings = replace(FEW, cells=3, cell_periods=40, trials=2, range_points=3)
    return Study(file, settings, SerialRunner(), Noting(), lambda *each: told.append(each)), told


def test_a_study_needs_no_more_than_a_file(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(oscillator().to_toml(), "utf-8")
    file = read_design_file(str(tmp_path / "mine.toml"))
    assert [each.contacts for each in Study(file).linear()] == [
        each.contacts for each in study(file.mechanism)[0].linear()
    ]
    with pytest.raises(WrongTypeError, match="path"):
        read_design_file(3)  # type: ignore[arg-type]


def test_a_whole_and_a_short_look_have_their_stages() -> None:
    mechanism = replace(oscillator(), stops={"wall": Stop(ENDS, 2e4, 50.0, 4e-3)})
    made, told = study(mechanism, OpenRange("frequency", "Hz", 19.0, 21.0, False))
    whole = made.whole()
    expected = ["motions", "linear", "ranges", "around", "sensitivities", "remedies", "neighbours"]
    expected += ["branch", "branch", "sliders"]
    assert [each for each in made.keeper.names if each != "row"] == expected  # type: ignore[attr-defined]
    assert told[:2] == [(Stage.MOTIONS, (), 0, 1), (Stage.MOTIONS, (), 1, 1)]
    branches = [over for stage, over, done, _ in told if stage is Stage.BRANCH and done]
    (drawn,) = whole.maps
    assert drawn.targets == (TARGET,) and set(drawn.result.chosen) == {STROKE.column}
    assert branches == [(drawn.first.place,), (drawn.second.place,)]
    assert [set(each.up.measures) for each in whole.paths if each.up] == [{STROKE.column}] * 2
    assert (Stage.MAP, (drawn.first.place, drawn.second.place), 3, 3) in told
    assert whole.cut == ()
    assert [len(each.result.cells) for each in whole.maps] == [9]
    assert whole.verdict.missed == (TARGET,) and whole.remedies is not None and whole.ranges is not None
    assert whole.motion is whole.motions.first
    assert whole.varied == varied_places(mechanism, whole.motion)
    assert set(whole.spectra) == {"block", "double"}
    short, _ = study(mechanism)
    brief = short.short()
    assert short.keeper.names == ["motions", "linear", "around", "neighbours"]  # type: ignore[attr-defined]
    assert (brief.maps, brief.paths) == ((), ())
    assert brief.sensitivities is brief.remedies is brief.ranges is None
    assert brief.verdict.missed == (TARGET,) and set(brief.spectra) == {"block", "double"}
    assert replace(FEW, cells=9).without_cells == replace(FEW, cells=0)


def test_what_does_not_repeat_or_swings_for_ever_has_fewer_stages() -> None:
    def motions(first: FoundMotion, failed: bool = False) -> Motions:
        return Motions((first,), 2, 5, 0, "", failed)

    speed = (VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 20.0, 19.0, 21.0),)
    repeating, chaos = motion(state=np.zeros(2)), motion(kind=MotionKind.CHAOTIC)
    made, _ = study(oscillator())
    for bad in (motions(repeating, failed=True), motions(chaos)):
        assert made.sensitivities(bad) is None
        assert made.paths(bad, speed) == ()
    assert made.spectra(motions(repeating, failed=True), ()) == {}
    assert made.paths(motions(motion(neutral=True)), speed) == ()
    assert [each.varied for each in made.paths(motions(repeating), speed)] == list(speed)
    free = replace(oscillator(), frequency=None, forces={})
    still, _ = study(free)
    assert still.maps(speed) == ()
    assert still.motions().starts == 1
    whole = still.whole()
    assert (whole.paths, whole.grid) == ((), None) and whole.remedies is not None
    roomy = motion(outputs={"block": output(0.0, 1.0)})
    assert made.remedies(replace(whole.verdict, judged=()), None) is None and roomy.repeats
