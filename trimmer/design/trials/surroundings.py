"""Whether targets hold beside the file's own point: at neighbouring speeds, and as numbers scatter."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum

import numpy as np

from trimmer.arrays import Reals
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.design_file import Scattering
from trimmer.design.specification.targets import Target
from trimmer.design.trials.trial import MeasureOfPart, Trial, TrialWork
from trimmer.errors import TrimmerError
from trimmer.maps.inputs import varied
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.runner import Runner

SPEEDS = (-0.05, 0.05, -0.025, 0.025, -0.0375, 0.0375, -0.0125, 0.0125)
"""Neighbouring speeds: relative changes of the frequency of the drive, those first that say most."""
FEW_SPEEDS, FEW_MACHINES = 4, 8  # Of each so many are looked at first

Numbers = tuple[tuple[str, float], ...]
"""Dotted places with the numbers, SI units, that stand there in place of those of the file."""


class Beside(Enum):
    """Where targets are looked at: at the point, at another speed, in another machine of the series."""

    POINT = "point"
    SPEED = "speed"
    SCATTER = "scatter"


@dataclass(frozen=True)
class Condition:
    """A change of speed, relative, or shifts of numbers, by place, under which targets shall hold too."""

    beside: Beside
    speed: float = 0.0
    shifts: Numbers = ()

    def of(self, mechanism: Mechanism, numbers: Numbers = ()) -> Numbers:
        """Return the numbers of a mechanism, of which some are changed, under this condition."""
        found = dict(numbers)
        for place, shift in self.shifts:
            found[place] = found.get(place, mechanism.value(place)) + shift
        if self.speed:
            found["frequency"] = (1 + self.speed) * found.get("frequency", mechanism.value("frequency"))
        return tuple(found.items())


def conditions_of(
    mechanism: Mechanism, uncertainty: Scattering | None, settings: DesignSettings
) -> tuple[Condition, ...]:
    """Return the point itself, speeds beside it, and machines as their numbers scatter."""
    speeds = SPEEDS if mechanism.frequency is not None else ()
    found = [Condition(Beside.POINT), *(Condition(Beside.SPEED, each) for each in speeds)]
    if uncertainty is not None and uncertainty.places:
        from scipy.stats import qmc

        shares = qmc.LatinHypercube(len(uncertainty.places), rng=settings.seed).random(settings.machines)
        centre = np.array([mechanism.value(place) for place in uncertainty.places])
        rows = uncertainty.values(shares) - centre
        found += [
            Condition(Beside.SCATTER, shifts=tuple(zip(uncertainty.places, row, strict=True)))
            for row in rows.tolist()
        ]
    return tuple(found)


def few_of(conditions: tuple[Condition, ...]) -> tuple[Condition, ...]:
    """Return the conditions that are looked at first: the point, and some of each kind beside it."""
    most = {Beside.POINT: 1, Beside.SPEED: FEW_SPEEDS, Beside.SCATTER: FEW_MACHINES}
    return tuple(
        each for kind in Beside for each in [one for one in conditions if one.beside is kind][: most[kind]]
    )


@dataclass(frozen=True)
class NumbersWork:
    """The work of a trial with some numbers of a mechanism changed, for some drive periods at most."""

    mechanism: Mechanism
    asked: tuple[MeasureOfPart, ...]
    most_periods: int

    def __call__(self, numbers: Numbers) -> tuple[Numbers, Trial | None]:
        """Return what the mechanism does with these numbers; None if it cannot have them."""
        places, values = tuple(place for place, _ in numbers), tuple(value for _, value in numbers)
        try:
            varied(self.mechanism, places, values)
        except TrimmerError:
            return numbers, None
        return numbers, TrialWork(self.mechanism, places, self.asked, self.most_periods)(values)


def trials_of(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    wanted: Iterable[Numbers],
    most_periods: int,
    runner: Runner,
) -> dict[Numbers, Trial]:
    """Return what a mechanism does with other numbers, as far as it can have them and the runner gets to."""
    asked = tuple(dict.fromkeys(MeasureOfPart(each.measure, each.part) for each in targets))
    work = NumbersWork(mechanism, asked, most_periods)
    found = runner.results(work, list(dict.fromkeys(wanted)))
    return {numbers: trial for numbers, trial in found if trial is not None}


def margins(trial: Trial, targets: tuple[Target, ...]) -> Reals:
    """Return the margin of each target, from -1 to 1, (targets,); negative if it is missed."""
    failed = not trial.meets(())
    return np.array(
        [-1.0 if failed else target.margin(trial.value(target.measure, target.part)) for target in targets]
    )


@dataclass(frozen=True)
class Around:
    """What a mechanism does under conditions beside its own point, the point itself first."""

    targets: tuple[Target, ...]
    trials: tuple[tuple[Condition, Trial], ...]

    def beside(self, *kinds: Beside) -> tuple[tuple[Condition, Trial], ...]:
        """Return those of some kinds."""
        return tuple(each for each in self.trials if each[0].beside in kinds)

    def meeting(self, kind: Beside) -> tuple[int, int]:
        """Return how many of a kind meet all targets, and how many there are."""
        met = [trial.meets(self.targets) for _, trial in self.beside(kind)]
        return sum(met), len(met)

    def margin(self, *kinds: Beside) -> float:
        """Return the smallest margin of all targets under conditions of some kinds; 1 if there are none."""
        every = (margins(trial, self.targets).min() for _, trial in self.beside(*kinds))
        return float(min(every, default=1.0))

    def worst(self, target: Target, *kinds: Beside) -> tuple[Condition, float] | None:
        """Return the condition in which a target has the smallest margin, and its value there."""
        every = [(each, trial.value(target.measure, target.part)) for each, trial in self.beside(*kinds)]
        return min(every, key=lambda each: target.margin(each[1]), default=None)

    @property
    def missed(self) -> tuple[Target, ...]:
        """The targets that are missed under some condition."""
        return tuple(target for target in self.targets if any(self._missing(target)))

    @property
    def holds(self) -> bool:
        """Whether all targets are met under all conditions."""
        return not self.missed

    def _missing(self, target: Target) -> Iterator[bool]:
        return (not trial.meets((target,)) for _, trial in self.trials)


def study_around(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    conditions: tuple[Condition, ...],
    settings: DesignSettings,
    runner: Runner,
    numbers: tuple[Numbers, ...] = ((),),
) -> list[Around]:
    """Look at a mechanism, once for each set of changed numbers, under conditions beside its own point.

    Conditions that no mechanism can have, such as a negative gap, are left out, and those that the runner
    leaves out.
    """
    wanted = [[each.of(mechanism, one) for each in conditions] for one in numbers]
    flat = [each for one in wanted for each in one]
    found = trials_of(mechanism, targets, flat, settings.cell_periods, runner)
    return [
        Around(
            targets,
            tuple(
                (condition, found[each])
                for condition, each in zip(conditions, one, strict=True)
                if each in found
            ),
        )
        for one in wanted
    ]
