"""How the verdict depends on unknown numbers, and which of them to measure first."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Flags, Integers, Reals
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.design_file import OpenRange
from trimmer.design.specification.targets import Target, is_switched
from trimmer.design.trials.trial import MeasureOfPart, Trial, TrialWork, all_measures
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.runner import Runner

EACH = 3  # Powers of two by which the points of several ranges exceed those of one
BINS = 4  # Parts of a range among which the trials are told apart, to say what its value would tell


@dataclass(frozen=True)
class Narrowing:
    """How much a measurement of one unknown number would narrow the verdict.

    Attributes:
        range: The number.
        doubt: Chance that two points in the same part of its range are judged differently.
        spread: Share of the variance of each measure that is left then, the mean; 1 where nothing is gained.
    """

    range: OpenRange
    doubt: float
    spread: float


@dataclass(frozen=True)
class RangeStudy:
    """How the verdict depends on unknown numbers, from points of their ranges.

    Attributes:
        ranges: The numbers that nobody knows.
        trials: What the mechanism does from rest at points of the ranges; values in the order of the ranges.
        meeting: Share of the points that meet all targets; None without targets.
        doubt: Chance that two points, whatever they are, are judged differently; 0 without targets.
        narrowings: What a measurement of each would tell, the most telling first.
    """

    ranges: tuple[OpenRange, ...]
    trials: tuple[Trial, ...]
    meeting: float | None
    doubt: float
    narrowings: tuple[Narrowing, ...]

    def extremes(self, asked: MeasureOfPart) -> tuple[float, float]:
        """Return the smallest and the largest value of a measure that was seen."""
        values = [value for value in self._values(asked) if not np.isnan(value)]
        return (min(values), max(values)) if values else (float("nan"), float("nan"))

    def _values(self, asked: MeasureOfPart) -> list[float]:
        return [trial.value(asked.measure, asked.part) for trial in self.trials]


def study_ranges(
    mechanism: Mechanism,
    ranges: tuple[OpenRange, ...],
    targets: tuple[Target, ...],
    settings: DesignSettings,
    runner: Runner,
    *,
    stepped: bool = False,
) -> RangeStudy | None:
    """Look at points of the ranges: evenly spaced for one, points of a Sobol sequence for several.

    Where it is ``stepped``, what controllers make of their steps is measured. Points that the runner leaves
    out are missing; None if all are.
    """
    places = tuple(each.place for each in ranges)
    switched = is_switched(mechanism, (each.measure for each in targets))
    asked = all_measures(mechanism, switched=switched, stepped=stepped)
    work = TrialWork(mechanism, places, asked, settings.cell_periods)
    shares = _points(len(ranges), settings)
    lowest = np.array([each.lowest for each in ranges])
    lengths = np.array([each.highest - each.lowest for each in ranges])
    values = [tuple(map(float, row)) for row in lowest + shares * lengths]
    found = {each.values: each for each in runner.results(work, values)}
    if not found:
        return None
    there = [at for at, each in enumerate(values) if each in found]
    trials, shares = tuple(found[values[at]] for at in there), shares[there]
    met = np.array([trial.meets(targets) for trial in trials])
    doubt = _doubt(met) if targets else 0.0
    narrowings = sorted(
        (_narrowing(each, shares[:, at], trials, met, targets, asked) for at, each in enumerate(ranges)),
        key=lambda each: (each.doubt, each.spread),
    )
    return RangeStudy(ranges, trials, float(met.mean()) if targets else None, doubt, tuple(narrowings))


def _points(count: int, settings: DesignSettings) -> Reals:
    """Return points of a unit cube, (points, count)."""
    if count == 1:
        return np.linspace(0.0, 1.0, settings.range_points)[:, None]
    from scipy.stats import qmc

    points = int(np.ceil(np.log2(settings.range_points))) + min(count, EACH) - 1
    # Not scrambled, so that no random number is in it; moved off the corner in which it begins.
    return np.asarray(qmc.Sobol(count, scramble=False).random_base2(points) + 0.5 / 2**points)


def _narrowing(
    of: OpenRange,
    shares: Reals,
    trials: tuple[Trial, ...],
    met: Flags,
    targets: tuple[Target, ...],
    asked: tuple[MeasureOfPart, ...],
) -> Narrowing:
    bins = np.minimum((shares * BINS).astype(int), BINS - 1)
    groups = [np.flatnonzero(bins == number) for number in range(BINS)]
    groups = [group for group in groups if group.size]
    doubt = sum(group.size * _doubt(met[group]) for group in groups) / len(trials) if targets else 0.0
    left = [_variance_left(asked_for, trials, groups) for asked_for in asked]
    told = [each for each in left if each is not None]
    return Narrowing(of, float(doubt), float(np.mean(told)) if told else 1.0)


def _doubt(met: Flags) -> float:
    """Return the chance that two points drawn from these are judged differently."""
    share = float(met.mean())
    return 2 * share * (1 - share)


def _variance_left(asked: MeasureOfPart, trials: tuple[Trial, ...], groups: list[Integers]) -> float | None:
    """Return the share of a measure's variance within the groups; None where it has none."""
    values = np.array([trial.value(asked.measure, asked.part) for trial in trials])
    if not np.isfinite(values).all() or values.var() <= 1e-12 * np.mean(values**2):
        return None
    return float(sum(group.size * values[group].var() for group in groups) / (len(values) * values.var()))
