"""Samples of a mechanism or a loop whose numbers scatter: what each of them does."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any
from warnings import warn

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.design.specification.targets import Measure, Target
from trimmer.design.trials.trial import MeasureOfPart, Trial, TrialWork
from trimmer.maps.cell_motion import waited_for
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.flow import Flow
from trimmer.motion.subject import Subject
from trimmer.progress import progress_bar
from trimmer.response.by_itself.self_excited import STRETCHES
from trimmer.response.flows import called, flow_of, is_silent, searched
from trimmer.response.periodic.pace import is_driven, pace_of, waited
from trimmer.response.results.response import MotionKind
from trimmer.runners import ProcessRunner, Runner, SerialRunner
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table, attributes
from trimmer.uncertainty import sample_records
from trimmer.uncertainty.distributions import Uncertainty
from trimmer.uncertainty.points import left_out
from trimmer.uncertainty.sample_file import SampleFile
from trimmer.uncertainty.sample_inputs import SampleInputs, SampleSettings, sample_inputs
from trimmer.uncertainty.sample_records import NOWHERE, Keeping

FEW = 12  # Samples up to which other processes are not worth their beginning


@dataclass(frozen=True)
class SampleWork:
    """The work of a sample, given by its number and its values."""

    trial: TrialWork

    def __call__(self, sample: tuple[int, tuple[float, ...]]) -> tuple[int, Trial]:
        """Return the number and what the mechanism or loop does."""
        return sample[0], self.trial(sample[1])


@dataclass(frozen=True, eq=False, repr=False)
class Samples(Tabular, Drawn):
    """What the samples of a mechanism or a loop do, from rest or from its own start.

    ``plot`` draws how the first measure is distributed.

    Attributes:
        inputs: What they depend on.
        trials: One for each possible sample, in the order of the samples.
    """

    inputs: SampleInputs
    trials: tuple[Trial, ...]

    @property
    def targets(self) -> tuple[Target, ...]:
        """What is wanted."""
        return self.inputs.targets

    @property
    def asked(self) -> tuple[MeasureOfPart, ...]:
        """What was measured."""
        return self.inputs.asked

    @property
    def impossible(self) -> int:
        """How many samples no mechanism or loop can have; they are left out."""
        return int((~self.inputs.possible).sum())

    @property
    def failed(self) -> int:
        """How many motions could not be followed to their end."""
        return sum(trial.kind is None for trial in self.trials)

    def measured(self, asked: MeasureOfPart) -> Reals:
        """Return a measure of each trial, shape (trials,); not a number where the motion failed."""
        return np.array([trial.value(asked.measure, asked.part) for trial in self.trials], dtype=float)

    @cached_property
    def flow(self) -> Flow:
        """What moves, which knows the units of what is measured."""
        return flow_of(self.inputs.subject)

    def _told(self) -> str:
        kinds = (f"{count} {kind}" for kind, count in self.kinds.items())
        return f"{counted(len(self.trials), 'sample')}: {', '.join(kinds)}"

    def _table(self) -> Table:
        scatters = self.inputs.uncertainty.scatters
        asked = [each for each in self.asked if each.measure is not Measure.PERIOD]
        columns = (
            *(Column(each.place, each.unit, _value_at(at)) for at, each in enumerate(scatters)),
            *attributes(kind="", period_count=""),
            *(Column(each.column, each.unit(self.flow), _measure(each)) for each in asked),
        )
        return Table("Samples", self.trials, columns)

    @property
    def met(self) -> Flags:
        """Whether each trial meets all targets, shape (trials,)."""
        return np.array([trial.meets(self.targets) for trial in self.trials], dtype=bool)

    @property
    def kinds(self) -> dict[str, int]:
        """How many trials do what, by words such as ``period 3``, the most frequent first.

        What rests on the drive periods that were waited says so, as in a map: ``chaotic over 300 drive
        periods``.
        """
        words = [waited_for(_what(trial), self._waited) for trial in self.trials]
        return {
            word: words.count(word)
            for word in sorted(set(words), key=lambda word: (-words.count(word), word))
        }

    @property
    def _waited(self) -> str:
        inputs = self.inputs
        if inputs.stepped:
            return "a step"
        if is_silent(inputs.subject):
            return "the search for orbits"
        driven, most = is_driven(inputs.subject), inputs.settings.most_periods
        return waited(inputs.subject, most * pace_of(inputs.subject) if driven else sum(STRETCHES))

    @property
    def _followed(self) -> str:
        """How far each was followed, in words."""
        through = "through the step until it rests or hunts evenly"
        return through if self.inputs.stepped else f"for at most {self._waited}"

    @property
    def message(self) -> str:
        """What was drawn and looked at, in sentences."""
        settings, of_mechanism = self.inputs.settings, isinstance(self.inputs.subject, Mechanism)
        of_loop = "its own start" if getattr(self.inputs.subject, "start", None) else "rest"
        begun = "rest or the file's own start" if of_mechanism else of_loop
        told = f"{counted(len(self.inputs.values), 'sample')} ({settings.plan.word}, seed {settings.seed}), "
        if is_silent(self.inputs.subject):
            told += f"in each the largest of {searched(self.inputs.subject)}."
        else:
            told += f"each from {begun}, {self._followed}; other motions were not looked for."
        if assumed := [each.place for each in self.inputs.uncertainty.scatters if each.assumed]:
            told += f" Of {', '.join(assumed)} the file only gives a range, which was taken as uniform."
        if self.impossible:
            told += f" {left_out(self.impossible, called(self.inputs.subject))}."
        whose = "its" if self.failed == 1 else "their"
        failed = f" {counted(self.failed, 'motion')} could not be followed to {whose} end."
        return told + (failed if self.failed else "")


def _what(trial: Trial) -> str:
    if trial.kind is None:
        return "failed"
    hunts = trial.kind is MotionKind.PERIODIC and trial.period_count is None
    return "hunts evenly" if hunts else trial.kind.described(trial.period_count)


def _value_at(place: int) -> Callable[[Trial], float]:
    return lambda trial: trial.values[place]


def _measure(asked: MeasureOfPart) -> Callable[[Trial], float]:
    return lambda trial: trial.value(asked.measure, asked.part)


def sample(
    subject: Subject,
    uncertainty: Uncertainty,
    settings: SampleSettings | None = None,
    *,
    targets: tuple[Target, ...] = (),
    runner: Runner | None = None,
    keeping: Keeping = NOWHERE,
    quiet: bool = False,
) -> Samples:
    """Draw samples of a mechanism or a loop and find what each of them settles to.

    A sample belongs to its number: who computes it, and in what order, changes no digit.

    Args:
        subject: The mechanism or loop; of a loop at rest it is the largest of its stable orbits.
        uncertainty: What scatters, as ``uncertainty_from`` makes it.
        settings: How samples are drawn and looked at.
        targets: What is wanted.
        runner: Who does the work; by default processes on all cores, for a few samples this one.
        keeping: Where each sample is kept as soon as it is done.
        quiet: Show no progress bar.

    Raises:
        UncertaintyError: if too many samples are impossible.
        MechanismError, LoopError: if there is no number at a place that scatters.
        WrongTypeError: if it is neither a mechanism nor a loop.
        MapFileError: if the file cannot be gone on with.
        FileWriteError: if the file cannot be written.
    """
    inputs = sample_inputs(subject, uncertainty, settings or SampleSettings(), targets)
    trials = trials_of(inputs, runner, keeping, quiet=quiet)
    return Samples(inputs, trials)


def sample_mechanism(file: SampleFile, settings: SampleSettings | None = None, **others: Any) -> Samples:
    """Do what ``sample`` does, which has taken its place, with the content of a file."""
    told = (
        "trimmer.uncertainty.sample_mechanism(file) is "
        "trimmer.sample(file.subject, file.uncertainty, targets=file.targets) now"
    )
    warn(told, DeprecationWarning, stacklevel=2)
    return sample(file.subject, file.uncertainty, settings, targets=file.targets, **others)


def trials_of(
    inputs: SampleInputs, runner: Runner | None = None, keeping: Keeping = NOWHERE, *, quiet: bool = False
) -> tuple[Trial, ...]:
    """Return what each possible sample does, in the order of the samples."""
    done: dict[int, Trial] = {}
    if keeping.path is not None and keeping.resume:
        done = sample_records.resumed(keeping.path, inputs)
    elif keeping.path is not None:
        sample_records.begin(keeping.path, inputs, overwrite=keeping.overwrite)
    for number, trial in _computed(inputs, done, runner, keeping.path, quiet):
        done[number] = trial
    return tuple(done[number] for number in np.flatnonzero(inputs.possible).tolist())


def _computed(
    inputs: SampleInputs, done: dict[int, Trial], runner: Runner | None, path: Path | None, quiet: bool
) -> Iterator[tuple[int, Trial]]:
    """Yield the samples that are left as they come, behind a progress bar, and keep them in the file."""
    left = [number for number in np.flatnonzero(inputs.possible).tolist() if number not in done]
    if not left:
        return
    if runner is None:
        runner = ProcessRunner() if len(left) > FEW else SerialRunner()
    places = inputs.uncertainty.places
    work = SampleWork(TrialWork(inputs.subject, places, inputs.asked, inputs.settings.most_periods))
    samples = ((number, tuple(inputs.values[number].tolist())) for number in left)
    results = runner.results(work, samples)
    with progress_bar(
        description="samples", total=len(left) + len(done), initial=len(done), quiet=quiet
    ) as bar:
        for result in results if path is None else sample_records.append(path, results):
            bar.update()
            yield result
