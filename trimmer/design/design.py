"""All that a report on a design shows, computed stage by stage; each stage may be kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TypeVar

from trimmer.choices import Choice
from trimmer.design.design_file import DesignFile
from trimmer.design.found_motion import FoundMotion
from trimmer.design.keeping import NOT_KEPT, Keeper
from trimmer.design.kept_map import DesignMap, design_map
from trimmer.design.linear import LinearState, linear_states
from trimmer.design.motions import Motions, motions_from_starts, with_neighbours
from trimmer.design.paths import NumberPath, path_through
from trimmer.design.plausible import Question, questions
from trimmer.design.ranges import RangeStudy, study_ranges
from trimmer.design.remedies import Remedies, remedies
from trimmer.design.sensitivity import Sensitivities, sensitivities
from trimmer.design.settings import USUAL, DesignSettings
from trimmer.design.spectrum import OutputSpectrum, spectra
from trimmer.design.varied_places import VariedNumber, varied_places
from trimmer.design.verdict import DesignVerdict, verdict_on
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import Runner

Result = TypeVar("Result")


class Stage(Choice):
    """A stage of the work, whose words are shown while it goes on."""

    LINEAR = "modes and transfer functions"
    MOTIONS = "motions from several starts"
    NEIGHBOURS = "motions of neighbours"
    RANGES = "over what nobody knows"
    SENSITIVITIES = "what each number changes"
    REMEDIES = "what would meet the targets"
    BRANCH = "branch"
    MAP = "map"


Told = Callable[[Stage, tuple[str, ...], int, int], None]
"""Is told a stage, the places that it is over, how much of it is done, and of how much."""


def tell_nobody(stage: Stage, over: tuple[str, ...], done: int, whole: int) -> None:
    """Take what is told, and tell it nobody."""


@dataclass(frozen=True)
class Design:
    """All that was computed of a design.

    Attributes:
        file: What the file says.
        settings: How closely it was looked at.
        linear: With contacts closed, then open.
        motions: The motions that were found.
        varied: The numbers that maps, branches and margins are over.
        spectra: Lines of each output of the first motion.
        ranges: Over what nobody knows; None where the file leaves nothing open.
        questions: What is asked about.
        verdict: On the targets.
        maps: Over gap and speed, gap and friction; as far as the mechanism has them.
        paths: The branch through the working point over each number; empty where the motion does not repeat.
        sensitivities: Of the first motion; None where it does not repeat.
        remedies: What would meet them; None where they are met or there are none.
    """

    file: DesignFile
    settings: DesignSettings
    linear: tuple[LinearState, ...]
    motions: Motions
    varied: tuple[VariedNumber, ...]
    spectra: Mapping[str, OutputSpectrum]
    ranges: RangeStudy | None
    questions: tuple[Question, ...]
    verdict: DesignVerdict
    maps: tuple[DesignMap, ...] = ()
    paths: tuple[NumberPath, ...] = ()
    sensitivities: Sensitivities | None = None
    remedies: Remedies | None = None

    @property
    def motion(self) -> FoundMotion | None:
        """What the first start settles to; None if it could not be measured."""
        return self.motions.first


@dataclass(frozen=True)
class Study:
    """The work on a design, stage by stage.

    Attributes:
        file: The file.
        settings: How closely it is looked at.
        runner: Who computes the cells of maps and trials; processes on all cores by default.
        keeper: Keeps what is done; nothing by default.
        told: Is told of each stage.
    """

    file: DesignFile
    settings: DesignSettings = USUAL
    runner: Runner = field(default_factory=ProcessRunner)
    keeper: Keeper = NOT_KEPT
    told: Told = tell_nobody

    def whole(self) -> Design:
        """Compute everything."""
        short = self.short()
        of = self.sensitivities(short.motions)
        return replace(
            short,
            sensitivities=of,
            remedies=self.remedies(short.verdict, of),
            paths=self.paths(short.motions, short.varied),
            maps=self.maps(short.varied),
        )

    def short(self) -> Design:
        """Compute verdict, motions and spectra alone, as for a comparison."""
        motions, linear, ranges = self.motions(), self.linear(), self.ranges()
        return Design(
            file=self.file,
            settings=self.settings,
            linear=linear,
            motions=motions,
            varied=self.varied(motions),
            spectra=self.spectra(motions, linear),
            ranges=ranges,
            questions=questions(self.file.mechanism, motions.first),
            verdict=verdict_on(self.file.targets, motions, ranges),
        )

    def linear(self) -> tuple[LinearState, ...]:
        """Return modes and transfer functions."""
        return self._made(Stage.LINEAR, (), (), partial(linear_states, self.file.mechanism))

    def motions(self) -> Motions:
        """Return the motions, those that neighbours lead to among them."""
        settings, mechanism = self.settings, self.file.mechanism
        depends = (settings.starts, settings.seed, settings.most_periods)
        found = self._made(Stage.MOTIONS, (), depends, partial(motions_from_starts, mechanism, settings))
        near = self.varied(found)
        if mechanism.frequency is None or len(near) < 2:
            return found
        more = partial(with_neighbours, mechanism, found, near, settings, self.runner)
        return self._made(Stage.NEIGHBOURS, (), settings.without_cells, more)

    def varied(self, motions: Motions) -> tuple[VariedNumber, ...]:
        """Return the numbers that maps and branches are over."""
        return varied_places(self.file.mechanism, motions.first)

    def spectra(self, motions: Motions, linear: tuple[LinearState, ...]) -> Mapping[str, OutputSpectrum]:
        """Return the lines of the first motion."""
        return {} if motions.first is None else spectra(motions.first, self.file.mechanism.frequency, linear)

    def sensitivities(self, motions: Motions) -> Sensitivities | None:
        """Return what each number changes."""
        if motions.first is None or not motions.first.repeats:
            return None
        make = partial(sensitivities, self.file.mechanism, motions.first)
        return self._made(Stage.SENSITIVITIES, (), (), make)

    def ranges(self) -> RangeStudy | None:
        """Return how the verdict depends on unknown numbers."""
        file = self.file
        if not file.ranges or file.mechanism.frequency is None:
            return None
        make = partial(study_ranges, file.mechanism, file.ranges, file.targets, self.settings, self.runner)
        depends = (file.ranges, file.targets, self.settings.range_points, self.settings.cell_periods)
        return self._made(Stage.RANGES, (), depends, make)

    def remedies(self, verdict: DesignVerdict, of: Sensitivities | None) -> Remedies | None:
        """Return what would meet the targets."""
        file = self.file
        if not verdict.missed or file.mechanism.frequency is None:
            return None
        settings = self.settings
        make = partial(remedies, file.mechanism, file.targets, verdict.missed, of, settings, self.runner)
        return self._made(Stage.REMEDIES, (), (file.targets, settings.without_cells), make)

    def paths(self, motions: Motions, varied: tuple[VariedNumber, ...]) -> tuple[NumberPath, ...]:
        """Return the branch through the working point over each number."""
        first = motions.first
        if first is None or not first.repeats or first.neutral or self.file.mechanism.frequency is None:
            return ()
        most = self.settings.most_points
        return tuple(
            self._made(
                Stage.BRANCH,
                (each.place,),
                (each, most),
                partial(path_through, self.file.mechanism, each, first, most),
            )
            for each in varied
        )

    def maps(self, varied: tuple[VariedNumber, ...]) -> tuple[DesignMap, ...]:
        """Return the maps over gap and speed, and gap and friction; without a gap over speed and friction."""
        if self.file.mechanism.frequency is None:
            return ()
        by_role = tuple({each.role: each for each in varied}.values())
        return tuple(self._map(by_role[0], each) for each in by_role[1:])

    def _map(self, first: VariedNumber, second: VariedNumber) -> DesignMap:
        over = (first.place, second.place)
        mechanism = self.file.mechanism
        return design_map(
            mechanism, first, second, self.settings, self.runner, self.keeper,
            partial(self.told, Stage.MAP, over),
        )  # fmt: skip

    def _made(
        self, stage: Stage, over: tuple[str, ...], depends: object, make: Callable[[], Result]
    ) -> Result:
        self.told(stage, over, 0, 1)
        result = self.keeper.made(stage.name.lower(), (over, depends), make)
        self.told(stage, over, 1, 1)
        return result
