"""Which change of one number would meet the targets that are missed; each is tried, not extrapolated."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.design.sensitivity import designable
from trimmer.design.targets import Target
from trimmer.design.trial import Asked, Trial, TrialWork, all_measures

if TYPE_CHECKING:
    from trimmer.design.sensitivity import Sensitivities
    from trimmer.maps.runner import Runner
    from trimmer.mechanism.mechanism import Mechanism

FARTHEST = 3.0
"""Largest factor by which a number is changed."""
FACTORS = 20
"""Trials to each side, evenly spaced on a logarithmic scale."""
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
    """

    place: str
    unit: str
    before: float
    after: float
    trial: Trial

    @property
    def change(self) -> float:
        """The logarithm of the factor."""
        return math.log(self.after / self.before)


@dataclass(frozen=True)
class Remedies:
    """What was tried to meet the targets.

    Attributes:
        found: Changes that meet all targets, the smallest first.
        tried: Places that were tried.
        trials: How many motions were computed.
        farthest: Largest factor that was tried.
    """

    found: tuple[Remedy, ...]
    tried: tuple[str, ...]
    trials: int
    farthest: float


def remedies(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    missed: tuple[Target, ...],
    sensitivities: Sensitivities | None,
    most_periods: int,
    runner: Runner,
) -> Remedies:
    """Look for the nearest value of one number at a time that meets all targets.

    Args:
        mechanism: The mechanism.
        targets: All targets.
        missed: Those that are missed now.
        sensitivities: What each number changes, by which those are chosen that are tried; without it all are.
        most_periods: Drive periods to wait for each motion to settle.
        runner: Who does the work.
    """
    places = _places(mechanism, missed, sensitivities)
    sides = np.geomspace(1, FARTHEST, FACTORS + 1)[1:]
    found, trials = [], 0
    for place, unit, value in places:
        work = TrialWork(mechanism, (place,), all_measures(mechanism), most_periods)
        values = [value * factor for factor in (*(1 / sides), *sides)]
        results = {each.values[0]: each for each in runner.results(work, [(each,) for each in values])}
        trials += len(results)
        for side in (values[:FACTORS], values[FACTORS:]):
            remedy = _nearest(work, value, [results[each] for each in side], targets)
            if remedy is not None:
                found.append(Remedy(place, unit, value, remedy.values[0], remedy))
                trials += HALVINGS + 1
    found.sort(key=lambda remedy: abs(remedy.change))
    return Remedies(tuple(found), tuple(place for place, _, _ in places), trials, FARTHEST)


def _places(
    mechanism: Mechanism, missed: tuple[Target, ...], sensitivities: Sensitivities | None
) -> list[tuple[str, str, float]]:
    every = list(designable(mechanism))
    asked = [Asked(each.measure, each.part) for each in missed]
    ranked = _interleaved([[e.place for e in sensitivities.ranked(a)] for a in asked] if sensitivities else [])
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
