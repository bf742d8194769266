"""The work on a design, stage by stage; each stage may be kept."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TypeVar

import numpy as np

from trimmer.deadline import NEVER, Deadline
from trimmer.design.analysis.linear import LinearState, linear_states
from trimmer.design.analysis.plausible import questions
from trimmer.design.analysis.spectrum import OutputSpectrum, spectra
from trimmer.design.design import Design, Stage
from trimmer.design.motions import Motions, motions_from_starts, periods_within, with_neighbours
from trimmer.design.parameter_studies.keeping import NOT_KEPT, Keeper
from trimmer.design.parameter_studies.kept_map import DesignMap, design_map, keys_of
from trimmer.design.parameter_studies.paths import NumberPath, path_through
from trimmer.design.parameter_studies.solved_grid import MovedNumber, SolvedGrid, numbers_to_move, solved_grid
from trimmer.design.parameter_studies.strongest import MAPS, pairs_of_targets
from trimmer.design.settings import USUAL, DesignSettings
from trimmer.design.specification.design_file import DesignFile
from trimmer.design.specification.targets import Target
from trimmer.design.trials.ranges import RangeStudy, study_ranges
from trimmer.design.trials.remedies import Remedies
from trimmer.design.trials.remedy_search import remedies
from trimmer.design.trials.sensitivity import Sensitivities, sensitivities
from trimmer.design.trials.surroundings import Around, Condition, conditions_of, study_around
from trimmer.design.varied_places import VariedNumber, varied_places
from trimmer.design.verdict import DesignVerdict, verdict_on
from trimmer.maps.cells import Cell, CellResult
from trimmer.runners import ProcessRunner, Runner
from trimmer.runners.timed import TimedRunner

Result = TypeVar("Result")

SPENT = {
    Stage.MOTIONS: 0.2,
    Stage.RANGES: 0.3,
    Stage.AROUND: 0.35,
    Stage.SENSITIVITIES: 0.4,
    Stage.REMEDIES: 0.62,
    Stage.NEIGHBOURS: 0.67,
    Stage.MAP: 0.76,
    Stage.BRANCH: 0.79,
    Stage.SLIDERS: 0.84,
}
"""Share of the time that is allowed after which each stage is over; the rest is for equations and pages."""
MOST_DRAWN = 3  # Targets that are drawn beside the map of hunting at most
MOST_PATHS = 3  # Numbers over which branches are followed at most
COARSE = (6, 12)  # Cells along each side of coarse maps, by which the time of finer ones is known
FIRST_START, CELL = 0.1, 0.02
"""Share of that time that a start may take to settle, and a cell of a map or a trial."""


Told = Callable[[Stage, tuple[str, ...], int, int], None]
"""Is told a stage, the places that it is over, how much of it is done, and of how much.

All of it is one of one; it was left out, as there was no time for it, at none of none.
"""


def tell_nobody(stage: Stage, over: tuple[str, ...], done: int, whole: int) -> None:
    """Take what is told, and tell it nobody."""


NO_MOTIONS = Motions((), 0, 0, 0, "", first_failed=True)


def _no_motions(cell: Cell) -> CellResult:
    """Return what stands for a cell that is not done."""
    return CellResult(cell.number, ())


@dataclass(frozen=True)
class Study:
    """The work on a design, stage by stage.

    Attributes:
        file: The file.
        settings: How closely it is looked at.
        runner: Who computes the cells of maps and trials; processes on all cores by default.
        keeper: Keeps what is done; nothing by default.
        told: Is told of each stage.
        deadline: After which nothing more is begun; each stage has its share of the time until then.
    """

    file: DesignFile
    settings: DesignSettings = USUAL
    runner: Runner = field(default_factory=ProcessRunner)
    keeper: Keeper = NOT_KEPT
    told: Told = tell_nobody
    deadline: Deadline = NEVER
    _cut: list[tuple[Stage, tuple[str, ...]]] = field(default_factory=list, compare=False)

    def whole(self) -> Design:
        """Compute everything, what the verdict needs first."""
        study = self._paced()
        motions, linear, ranges = study.motions(), study.linear(), study.ranges()
        around, of = study.around(motions), study.sensitivities(motions)
        verdict = verdict_on(self.file.targets, motions, ranges, around)
        found = study.remedies(verdict, of)
        motions = study.with_neighbours(motions)
        varied = study.varied(motions)
        pairs = study.pairs(verdict, varied, of, found)
        maps = study.maps(varied, pairs)
        numbers = tuple(dict.fromkeys(each for pair in pairs for each in pair))
        paths = study.paths(motions, numbers[:MOST_PATHS] or varied)
        grid = study.grid(motions, numbers_to_move(self.file.mechanism, varied, numbers, found))
        return replace(
            study._design(motions, linear, ranges, around),
            sensitivities=of,
            remedies=found,
            paths=paths,
            maps=maps,
            grid=grid,
        )

    def short(self) -> Design:
        """Compute verdict, motions and spectra alone, as for a comparison."""
        study = self._paced()
        motions, linear, ranges = study.motions(), study.linear(), study.ranges()
        around = study.around(motions)
        return study._design(study.with_neighbours(motions), linear, ranges, around)

    def _design(
        self,
        motions: Motions,
        linear: tuple[LinearState, ...],
        ranges: RangeStudy | None,
        around: Around | None,
    ) -> Design:
        return Design(
            file=self.file,
            settings=self.settings,
            linear=linear,
            motions=motions,
            varied=self.varied(motions),
            spectra=self.spectra(motions, linear),
            ranges=ranges,
            questions=questions(self.file.mechanism, motions.first),
            verdict=verdict_on(self.file.targets, motions, ranges, around),
            around=around,
            deadline=self.deadline,
            cut=tuple(self._cut),
        )

    def _paced(self) -> Study:
        """Return the same with as many drive periods for a start or a cell as there is time for."""
        settings, allowed = self.settings, self.deadline.left
        starts, cells = (
            periods_within(self.file.mechanism, most, share * allowed)
            for most, share in ((settings.most_periods, FIRST_START), (settings.cell_periods, CELL))
        )
        paced = replace(settings, most_periods=starts, cell_periods=cells)
        return replace(self, settings=paced, _cut=[])

    def linear(self) -> tuple[LinearState, ...]:
        """Return modes and transfer functions."""
        return self.keeper.made("linear", (), partial(linear_states, self.file.mechanism))

    def motions(self) -> Motions:
        """Return what several starts lead to; the first is followed whatever time is left."""
        settings = self.settings
        depends = (settings.starts, settings.seed, settings.most_periods, self.file.switched)

        def make(runner: TimedRunner) -> Motions:
            return motions_from_starts(
                self.file.mechanism, settings, runner.deadline, switched=self.file.switched
            )

        return self._made(Stage.MOTIONS, (), depends, make, NO_MOTIONS)

    def with_neighbours(self, motions: Motions) -> Motions:
        """Return the motions, those that neighbours lead to among them."""
        near = self.varied(motions)
        if self.file.mechanism.frequency is None or self.file.switched or self.file.stepped or len(near) < 2:
            return motions

        def make(runner: TimedRunner) -> Motions:
            whole = replace(runner, instead=_no_motions)
            found = with_neighbours(self.file.mechanism, motions, near, self.settings, whole)
            if found.neighbours is None or not runner.deadline.passed:
                return found
            return replace(found, neighbours=replace(found.neighbours, complete=False))

        return self._made(Stage.NEIGHBOURS, (), self.settings.without_cells, make, motions)

    def varied(self, motions: Motions) -> tuple[VariedNumber, ...]:
        """Return the numbers that maps and branches are over."""
        return varied_places(self.file.mechanism, motions.first)

    def spectra(self, motions: Motions, linear: tuple[LinearState, ...]) -> Mapping[str, OutputSpectrum]:
        """Return the lines of the first motion."""
        first = motions.first
        if first is None or first.switched is not None:
            return {}
        return spectra(first, self.file.mechanism.frequency, linear)

    def sensitivities(self, motions: Motions) -> Sensitivities | None:
        """Return what each number changes."""
        first = motions.first
        file = self.file
        if first is None or not (first.repeats or file.switched or file.stepped):
            return None

        def make(runner: TimedRunner) -> Sensitivities:
            return sensitivities(file.mechanism, first, runner.deadline, stepped=file.stepped)

        return self._made(Stage.SENSITIVITIES, (), (file.switched, file.stepped), make, None)

    def ranges(self) -> RangeStudy | None:
        """Return how the verdict depends on unknown numbers."""
        file = self.file
        if not file.ranges:
            return None
        settings, stepped = self.settings, file.stepped
        make = partial(study_ranges, file.mechanism, file.ranges, file.targets, settings, stepped=stepped)
        depends = (file.ranges, file.targets, settings.range_points, settings.cell_periods)
        return self._made(Stage.RANGES, (), depends, make, None)

    def around(self, motions: Motions) -> Around | None:
        """Return whether the targets hold at neighbouring speeds, and as numbers scatter."""
        file, settings = self.file, self.settings
        if not file.targets or motions.first is None:
            return None
        conditions = self._conditions

        def make(runner: TimedRunner) -> Around:
            return study_around(file.mechanism, file.targets, conditions, settings, runner)[0]

        depends = (file.targets, conditions, settings.cell_periods)
        return self._made(Stage.AROUND, (), depends, make, None)

    def remedies(self, verdict: DesignVerdict, of: Sensitivities | None) -> Remedies | None:
        """Return what would meet the targets."""
        file, settings = self.file, self.settings
        if not verdict.missed:
            return None
        conditions = self._conditions

        def make(runner: TimedRunner) -> Remedies:
            return remedies(file.mechanism, file.targets, verdict.missed, of, conditions, settings, runner)

        depends = (file.targets, conditions, settings.without_cells)
        return self._made(Stage.REMEDIES, (), depends, make, None)

    @property
    def _conditions(self) -> tuple[Condition, ...]:
        return conditions_of(self.file.mechanism, self.file.uncertainty, self.settings)

    def pairs(
        self,
        verdict: DesignVerdict,
        varied: tuple[VariedNumber, ...],
        of: Sensitivities | None,
        found: Remedies | None,
    ) -> dict[tuple[VariedNumber, VariedNumber], tuple[Target, ...]]:
        """Return the pairs of numbers over which targets are drawn, those first that are missed."""
        others = (each for each in self.file.targets if each not in verdict.missed)
        wanted = (*verdict.missed, *others)
        pairs = pairs_of_targets(self.file.mechanism, wanted, varied, of, found)
        if not self.file.stepped or len(varied) < 2:
            return pairs
        # Whether an axis hunts is asked over gap and gain first, with what is missed beside it.
        hunting = {(varied[0], varied[1]): wanted[:MOST_DRAWN]}
        return dict(list({**hunting, **pairs}.items())[:MAPS])

    def paths(self, motions: Motions, varied: tuple[VariedNumber, ...]) -> tuple[NumberPath, ...]:
        """Return the branch through the working point over each number."""
        first, file = motions.first, self.file
        if first is None or not first.repeats or first.neutral or file.switched:
            return ()
        # What targets of a step bound is of the way to the motion.
        keys = () if file.stepped else keys_of(file.targets)
        mechanism, most = file.mechanism, self.settings.most_points

        def make(over: VariedNumber) -> Callable[[TimedRunner], NumberPath]:
            return lambda runner: path_through(mechanism, over, first, most, runner.deadline, keys=keys)

        found = (
            self._made(Stage.BRANCH, (each.place,), (each, most, keys), make(each), None) for each in varied
        )
        return tuple(each for each in found if each is not None and not each.hardly_begun)

    def maps(
        self,
        varied: tuple[VariedNumber, ...],
        pairs: Mapping[tuple[VariedNumber, VariedNumber], tuple[Target, ...]] | None = None,
    ) -> tuple[DesignMap, ...]:
        """Return maps over pairs of numbers with the targets drawn there.

        Without them they are over gap and speed, and gap and friction; without a gap over speed and friction.
        """
        by_role = tuple({each.role: each for each in varied}.values())
        wanted = pairs or {(by_role[0], each): () for each in by_role[1:]}
        shares = np.linspace(SPENT[Stage.NEIGHBOURS], SPENT[Stage.MAP], len(wanted) + 1)[1:].tolist()
        found = []
        for ((first, second), targets), share in zip(wanted.items(), shares, strict=True):
            # Where an axis hunts matters most.
            deadline = self.deadline.share(SPENT[Stage.MAP] if self.file.stepped else share)
            found.append(self._map(first, second, targets, deadline))
        return tuple(each for each in found if each is not None)

    def grid(self, motions: Motions, moved: tuple[MovedNumber, ...]) -> SolvedGrid | None:
        """Return motions over a grid of numbers, for sliders."""
        file, first = self.file, motions.first
        driven = file.mechanism.frequency is not None or file.switched
        if not driven or file.stepped or first is None or not moved:
            return None
        shaken = None if file.switched else first.body_felt(file.held, file.targets)
        settings, switched = self.settings, file.switched

        def make(runner: TimedRunner) -> SolvedGrid | None:
            targets, mechanism = file.targets, file.mechanism
            return solved_grid(mechanism, moved, targets, shaken, settings, runner, switched=switched)

        depends = (moved, file.targets, shaken, settings.cell_periods, settings.grid)
        return self._made(Stage.SLIDERS, tuple(each.number.place for each in moved), depends, make, None)

    def _map(
        self, first: VariedNumber, second: VariedNumber, targets: tuple[Target, ...], deadline: Deadline
    ) -> DesignMap | None:
        """Return a map as fine as there is time for: a coarse one tells how long a finer one takes."""
        over, best = (first.place, second.place), None
        runner = TimedRunner(self.runner, deadline)
        sizes = [self.settings.cells] if deadline.end == math.inf else [*self._sizes()]
        left = deadline.left
        for cells, before in zip(sizes, [None, *sizes], strict=False):
            took = left - deadline.left
            if before is not None and took * (cells / before) ** 2 > deadline.left:
                break
            left = deadline.left
            settings = replace(self.settings, cells=cells)
            told = partial(self.told, Stage.MAP, over)
            finer = design_map(
                *(self.file.mechanism, first, second, settings, runner, self.keeper, told, targets),
                stepped=self.file.stepped,
            )
            best = finer or best
        if best is None:
            return self._left_out(Stage.MAP, over, None)
        self.told(Stage.MAP, over, 1, 1)
        return best

    def _sizes(self) -> Iterator[int]:
        yield from (each for each in COARSE if each < self.settings.cells)
        yield self.settings.cells

    def _made(
        self,
        stage: Stage,
        over: tuple[str, ...],
        depends: object,
        make: Callable[[TimedRunner], Result],
        otherwise: Result,
    ) -> Result:
        """Return a stage, kept or made; one that the time has cut short is noted, and not kept."""

        def told(done: int, count: int) -> None:
            if count > 1:  # a single cell says nothing that the whole stage does not
                self.told(stage, over, done, count)

        deadline = self.deadline.share(SPENT[stage])
        key = stage.name.lower(), (over, depends)
        result: Result | None = self.keeper.kept(*key)
        if result is None and deadline.passed and stage is not Stage.MOTIONS:
            return self._left_out(stage, over, otherwise)
        if result is None:
            self.told(stage, over, 0, 1)
            result = make(TimedRunner(self.runner, deadline, told=told))
            if deadline.passed:
                self._cut.append((stage, over))
            elif result is not None:
                self.keeper.keep(*key, result)
        self.told(stage, over, 1, 1)
        return result

    def _left_out(self, stage: Stage, over: tuple[str, ...], otherwise: Result) -> Result:
        self._cut.append((stage, over))
        self.told(stage, over, 0, 0)
        return otherwise
