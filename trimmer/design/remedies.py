"""Which change of one number would meet the targets that are missed; each is tried, not extrapolated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import takewhile

import numpy as np

from trimmer.deadline import NEVER, Deadline
from trimmer.design.motions import motions_from_starts
from trimmer.design.sensitivity import Sensitivities, designable
from trimmer.design.settings import DesignSettings
from trimmer.design.targets import Target
from trimmer.design.trial import MeasureOfPart, Trial, TrialWork, all_measures
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.runner import Runner

FARTHEST = 3.0
"""Largest factor by which a number is changed."""
HALVINGS = 6
"""How often the step between the last trial that misses and the first that meets is halved."""
PLACES = 12
"""Numbers that are tried, of those with the largest influence."""
DIGITS = 3
"""Digits to which a number is rounded, away from the bound."""


@dataclass(frozen=True)
class Remedy:
    """A change of one number after which all targets are met, from rest or the file's own start.

    Attributes:
        place: Dotted place of the number.
        unit: SI unit.
        before, after: Its value now, and the nearest one found that meets the targets.
        trial: What the mechanism does then.
        meeting: How many of several starts lead to a motion that meets them.
    """

    place: str
    unit: str
    before: float
    after: float
    trial: Trial
    meeting: int = 0

    @property
    def change(self) -> float:
        """The logarithm of the factor."""
        return math.log(self.after / self.before)


@dataclass(frozen=True)
class Remedies:
    """What was tried to meet the targets.

    Attributes:
        found: Changes that meet all targets: first those that do from all starts, each group by its size.
        starts: From how many starts each was tried.
        tried: Places that were tried.
        trials: How many motions were computed.
        farthest: Largest factor that was tried.
    """

    found: tuple[Remedy, ...]
    starts: int
    tried: tuple[str, ...]
    trials: int
    farthest: float


def remedies(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    missed: tuple[Target, ...],
    sensitivities: Sensitivities | None,
    settings: DesignSettings,
    runner: Runner,
    deadline: Deadline = NEVER,
) -> Remedies:
    """Look for the nearest value of one number at a time that meets all targets.

    Args:
        mechanism: The mechanism.
        targets: All targets.
        missed: Those that are missed now.
        sensitivities: What each number changes, by which those are chosen that are tried; without it all are.
        settings: How many starts there are, and how long each motion is waited for.
        runner: Who does the work.
        deadline: After which no further number is tried.
    """
    places = _places(mechanism, missed, sensitivities)
    found, trials = [], 0
    for place, unit, _ in takewhile(lambda _: not deadline.passed, places):
        of_place, count = remedies_by(mechanism, place, unit, targets, settings, runner)
        found += of_place
        trials += count
    confirmed = list(runner.results(_FromStarts(mechanism, targets, settings), found))
    confirmed.sort(key=lambda remedy: (remedy.meeting < settings.starts, abs(remedy.change)))
    tried = tuple(place for place, _, _ in places)
    return Remedies(tuple(confirmed), settings.starts, tried, trials, FARTHEST)


def remedies_by(
    mechanism: Mechanism,
    place: str,
    unit: str,
    targets: tuple[Target, ...],
    settings: DesignSettings,
    runner: Runner,
) -> tuple[list[Remedy], int]:
    """Look for the nearest values of one number, one smaller and one larger, that meet all targets.

    Returns:
        What was found, not yet tried from several starts, and how many motions were computed.
    """
    value = mechanism.value(place)
    work = TrialWork(mechanism, (place,), all_measures(mechanism), settings.cell_periods)
    factors = np.geomspace(1, FARTHEST, settings.trials + 1)[1:]
    sides = [[(value * float(factor),) for factor in each] for each in (1 / factors, factors)]
    results = {each.values: each for each in runner.results(work, [each for side in sides for each in side])}
    found, trials = [], len(results)
    for side in sides:
        remedy = _nearest(work, value, [results[each] for each in side if each in results], targets)
        if remedy is not None:
            found.append(Remedy(place, unit, value, remedy.values[0], remedy))
            trials += HALVINGS + 1
    return found, trials


@dataclass(frozen=True)
class _FromStarts:
    """Tries a remedy from several starts."""

    mechanism: Mechanism
    targets: tuple[Target, ...]
    settings: DesignSettings

    def __call__(self, remedy: Remedy) -> Remedy:
        changed = self.mechanism.with_value(remedy.place, remedy.after)
        motions = motions_from_starts(changed, self.settings)
        meeting = sum(each.starts for each in motions.found if each.meets(self.targets))
        return replace(remedy, meeting=meeting)


def _places(
    mechanism: Mechanism, missed: tuple[Target, ...], sensitivities: Sensitivities | None
) -> list[tuple[str, str, float]]:
    every = list(designable(mechanism))
    asked = [MeasureOfPart(each.measure, each.part) for each in missed]
    ranked = _interleaved(
        [[e.place for e in sensitivities.ranked(a)] for a in asked] if sensitivities else []
    )
    chosen = [each for each in every if each[0] in ranked[:PLACES]]
    others = [each for each in every if each not in chosen]
    return chosen if len(chosen) >= PLACES else [*chosen, *others[: PLACES - len(chosen)]]


def _interleaved(lists: Sequence[Sequence[str]]) -> list[str]:
    """Return the first of each list, then the second, and so on, each place once."""
    longest = max(map(len, lists), default=0)
    order: Iterator[str] = (each[at] for at in range(longest) for each in lists if at < len(each))
    return list(dict.fromkeys(order))


def _nearest(
    work: TrialWork, value: float, side: Iterable[Trial], targets: tuple[Target, ...]
) -> Trial | None:
    """Return the trial nearest to a value that meets the targets, on one side of it; None if none does."""
    before, best = value, None
    for trial in side:
        if trial.meets(targets):
            best = trial
            break
        before = trial.values[0]
    if best is None:
        return None
    for _ in range(HALVINGS):
        middle = work((math.sqrt(before * best.values[0]),))
        if middle.meets(targets):
            best = middle
        else:
            before = middle.values[0]
    rounded = work((_rounded(best.values[0], away_from=before),))
    return rounded if rounded.meets(targets) else best


def _rounded(value: float, away_from: float) -> float:
    """Return a value with few digits, rounded away from another one."""
    step = 10.0 ** (math.floor(math.log10(abs(value))) - DIGITS + 1)
    count = value / step
    whole = math.ceil(count - 1e-9) if value > away_from else math.floor(count + 1e-9)
    return float(f"{whole * step:.{DIGITS}g}")
