"""Which change of one number, or of two at once, would meet the targets, and hold beside that point too.

Each number is tried by itself over its range. From these trials a forecast says where one number or two meet
all targets with the largest margin; there the motion is computed at the point, at some neighbouring speeds
and for some machines as they scatter, the forecast is corrected by what came out, and so on. What holds there
is computed under all conditions, as far as there is time; where it breaks, the forecast is corrected again.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum

import numpy as np

from trimmer.arrays import Reals
from trimmer.design.motions import motions_from_starts
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.targets import Measure, Target, is_stepped, is_switched
from trimmer.design.trials.forecast import AMPLE, EFFORT, Forecast, Scan, is_regular, logs_of, scan_of
from trimmer.design.trials.remedies import Change, Mend, Remedies, Remedy
from trimmer.design.trials.sensitivity import Sensitivities, designable
from trimmer.design.trials.surroundings import (
    Around,
    Beside,
    Condition,
    Numbers,
    few_of,
    margins,
    study_around,
    trials_of,
)
from trimmer.design.trials.trial import MeasureOfPart, Trial
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place
from trimmer.runners.timed import TimedRunner

FARTHEST = 3.0  # Largest factor by which a number is changed
OWN = {"gap": (0.1, FARTHEST), "frequency": (1 / 1.5, 1.5)}
"""Smallest and largest factor of some: parts can be made to fit more closely; a speed is hardly free."""
PLACES = 16  # Numbers that are tried, of those with the largest influence
FIRST = (
    *("kp", "kv", "ki", "kd", "ti", "gap", "force", "amplitude", "frequency", "damping", "stiffness"),
    *("static", "viscous", "unbalance"),
)
"""Which numbers come first if nothing is known of their influence."""
SINGLES, PAIRS = 4, 8  # Changes of one number and of two that are computed, those with the best forecast
ROUNDS = 5  # How often a forecast is corrected
AGAIN = 2  # How often it is corrected after a change broke under one of all conditions
DIGITS = 3  # Digits to which a number is rounded
ALIKE = 0.02  # Margin that is given away for a change of one number in place of two


def remedies(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    missed: tuple[Target, ...],
    sensitivities: Sensitivities | None,
    conditions: tuple[Condition, ...],
    settings: DesignSettings,
    runner: TimedRunner,
) -> Remedies:
    """Look for changes of one number or two that meet all targets, at the point and beside it."""
    search = _Search(mechanism, targets, conditions, settings, runner)
    scans = search.scans(_places(mechanism, missed, sensitivities))
    reached = search.reached(scans) if scans else []
    held = [each for each in reached if each.beside and each.margin >= 0]
    found = search.from_starts(sorted(held, key=_rank))
    return Remedies(
        found=tuple(found),
        nearest=None if found else min(reached, key=_rank, default=None),
        mends=tuple(_mend(each, targets, scans) for each in missed if scans),
        starts=settings.remedy_starts,
        tried=tuple(each.place for each in scans),
        trials=search.count,
    )


def _rank(remedy: Remedy) -> float:
    """Return what is smallest for the best one: much margin, few changes, small ones."""
    effort = sum(abs(math.log(each.after / each.before)) for each in remedy.changes)
    return ALIKE * len(remedy.changes) + EFFORT * effort - min(remedy.margin, AMPLE)


@dataclass(frozen=True)
class _FromStarts:
    """Tries a remedy from several starts."""

    mechanism: Mechanism
    targets: tuple[Target, ...]
    settings: DesignSettings

    def __call__(self, remedy: Remedy) -> Remedy:
        changed = self.mechanism
        for each in remedy.changes:
            changed = changed.with_value(each.place, each.after)
        motions = motions_from_starts(changed, replace(self.settings, starts=self.settings.remedy_starts))
        meeting = sum(each.starts for each in motions.found if each.meets(self.targets))
        return replace(remedy, meeting=meeting)


class _Looked(IntEnum):
    """Where a change was computed: at its point, beside it too, under all conditions."""

    POINT = 0
    BESIDE = 1
    EVERYWHERE = 2


@dataclass
class _Candidate:
    """A change that is improved from round to round."""

    forecast: Forecast
    offset: Reals
    margin: float = -1.0
    avoided: list[Reals] = field(default_factory=list)
    seen: dict[Numbers, tuple[_Looked, Around]] = field(default_factory=dict)

    def numbers(self) -> Numbers:
        """Return the numbers to try next, rounded."""
        factors, self.margin = self.forecast.best(self.offset, tuple(self.avoided))
        scans = self.forecast.scans
        return tuple(
            (scan.place, float(f"{scan.value * math.exp(at):.{DIGITS}g}"))
            for scan, at in zip(scans, factors, strict=True)
        )

    def _factors(self, numbers: Numbers) -> Reals:
        pairs = zip(self.forecast.scans, numbers, strict=True)
        return np.array([math.log(value / scan.value) for scan, (_, value) in pairs])

    def best(self) -> tuple[Numbers, _Looked, Around] | None:
        """Return the best that was computed, where it was, and what came out."""
        found = ((numbers, *each) for numbers, each in self.seen.items())
        return max(found, key=lambda each: (each[1], each[2].margin(*Beside)), default=None)

    @property
    def is_unsure(self) -> bool:
        """Whether its best holds where it was computed, but was not computed under all conditions."""
        best = self.best()
        return best is not None and best[1] is _Looked.BESIDE and best[2].holds

    def learn(self, numbers: Numbers, around: Around, looked: _Looked) -> None:
        """Correct the forecast by what came out."""
        self.seen[numbers] = looked, around
        factors = self._factors(numbers)
        targets, trials = around.targets, [trial for _, trial in around.trials]
        if not all(is_regular(each, targets) for each in trials):
            self.avoided.append(factors)
            return
        logs = np.array([logs_of(each, targets) for each in trials])
        least = np.array([each.at_least for each in targets])
        worst = np.where(least, logs.min(axis=0), logs.max(axis=0))
        self.offset = worst - self.forecast.logs(factors)

    def remedy(self) -> Remedy | None:
        """Return the best that was computed."""
        best = self.best()
        if best is None:
            return None
        numbers, looked, around = best
        scans = self.forecast.scans
        changes = (
            Change(scan.place, scan.unit, scan.value, value)
            for scan, (_, value) in zip(scans, numbers, strict=True)
        )
        return Remedy(tuple(changes), around, looked > _Looked.POINT)


@dataclass
class _Search:
    mechanism: Mechanism
    targets: tuple[Target, ...]
    conditions: tuple[Condition, ...]
    settings: DesignSettings
    runner: TimedRunner
    count: int = 0

    def scans(self, places: Sequence[tuple[str, str, float]]) -> list[Scan]:
        """Try each number by itself, near values first, so that little time gives something of all."""
        factors = {place: _factors(place, self.settings.trials) for place, *_ in places}
        wanted: list[Numbers] = [
            ((place, value * float(factors[place][at])),)
            for at in _from_the_middle(2 * self.settings.trials + 1)
            for place, _, value in places
        ]
        found = trials_of(self.mechanism, self.targets, wanted, self.settings.cell_periods, self.runner)
        self.count += len(found)
        scans = []
        for place, unit, value in places:
            own = [trial for ((name, _),), trial in found.items() if name == place]
            if len(own) > 1 and any(each.values[0] == value for each in own):
                trials = tuple(sorted(own, key=lambda each: each.values[0]))
                scans.append(scan_of(place, unit, value, trials, self.targets))
        return scans

    def reached(self, scans: list[Scan]) -> list[Remedy]:
        """Return the best change of each choice of one number or two that is worth it."""
        own = next(each for each in scans[0].trials if each.values[0] == scans[0].value)
        nominal, regular = logs_of(own, self.targets), is_regular(own, self.targets)
        candidates = []
        for size, most in ((1, SINGLES), (2, PAIRS)):
            ones = [
                _Candidate(Forecast(self.targets, chosen, nominal, regular), np.zeros(len(self.targets)))
                for chosen in itertools.combinations(scans, size)
            ]
            for each in ones:
                _, each.margin = each.forecast.best(each.offset)
            candidates += sorted(ones, key=lambda each: -each.margin)[:most]
        for _ in range(ROUNDS):
            self._round(candidates, few_of(self.conditions), _Looked.BESIDE)
        broken = self._broken(candidates)
        for _ in range(AGAIN):
            self._round(broken, self.conditions, _Looked.EVERYWHERE)
        found = (each.remedy() for each in candidates)
        return [each for each in found if each is not None and each.is_needed]

    def _round(
        self, candidates: list[_Candidate], conditions: tuple[Condition, ...], looked: _Looked
    ) -> None:
        """Compute what the forecasts propose, at the point and then, where it is worth it, beside it."""
        proposed = [(each, each.numbers()) for each in candidates]
        fresh = [one for one in proposed if one[1] not in one[0].seen]
        best = sorted(self._computed(fresh, conditions[:1], _Looked.POINT), key=lambda each: -each[0])
        held = [one for margin, one in best[: max(SINGLES, PAIRS)] if margin >= 0]
        self._computed(held, conditions, looked)

    def _broken(self, candidates: list[_Candidate]) -> list[_Candidate]:
        """Compute under all conditions what holds under a few; return what breaks there."""
        unsure = [(each, best) for each in candidates if each.is_unsure and (best := each.best())]
        broken = []
        for each, (numbers, *_) in sorted(unsure, key=lambda one: -one[1][2].margin(*Beside)):
            found = self._computed([(each, numbers)], self.conditions, _Looked.EVERYWHERE)
            broken += [each for margin, _ in found if margin < 0]
        return broken

    def _computed(
        self, wanted: list[tuple[_Candidate, Numbers]], conditions: tuple[Condition, ...], looked: _Looked
    ) -> list[tuple[float, tuple[_Candidate, Numbers]]]:
        """Compute changes under conditions, the point first; return the margins of those that are done."""
        deadline = self.runner.deadline
        if not wanted or deadline.passed:
            return []
        numbers = tuple(one for _, one in wanted)
        arounds = study_around(self.mechanism, self.targets, conditions, self.settings, self.runner, numbers)
        whole = looked is _Looked.POINT or not self.runner.deadline.passed  # else some may be missing
        self.count += sum(len(each.trials) for each in arounds)
        done = []
        for one, around in zip(wanted, arounds, strict=True):
            if whole and around.trials and around.trials[0][0].beside is Beside.POINT:
                one[0].learn(one[1], around, looked)
                done.append((around.margin(*Beside), one))
        return done

    def from_starts(self, ranked: list[Remedy]) -> list[Remedy]:
        """Try remedies from several starts; those that do from all come first."""
        measures = [each.measure for each in self.targets]
        if is_switched(self.mechanism, measures) or is_stepped(measures):
            return ranked  # it always begins as the file says
        work = _FromStarts(self.mechanism, self.targets, self.settings)
        tried = {each.changes: each for each in self.runner.results(work, ranked)}
        confirmed = [tried.get(each.changes, each) for each in ranked]
        return sorted(confirmed, key=lambda each: each.meeting != self.settings.remedy_starts)


def _mend(target: Target, targets: tuple[Target, ...], scans: list[Scan]) -> Mend:
    """Return what a single number does for one target, from the trials over each number alone."""
    at = targets.index(target)
    moved = sorted(scans, key=lambda each: -_reach(each, at, target))
    strongest = tuple(each.place for each in moved)
    helping, helpless = [], []
    for scan in scans:
        meeting = [trial for trial in scan.trials if trial.meets((target,)) and trial.values[0] != scan.value]
        helping += [(scan, trial) for trial in meeting]
        if not meeting:
            helpless.append(scan.place)
    if not helping:
        return Mend(target, None, None, (), tuple(helpless), strongest)
    scan, trial = min(helping, key=lambda each: _cost(each[1], each[0], targets))
    missed = tuple(each for each in targets if not trial.meets((each,)))
    change = Change(scan.place, scan.unit, scan.value, trial.values[0])
    return Mend(target, change, trial.value(target.measure, target.part), missed, tuple(helpless), strongest)


def _reach(scan: Scan, at: int, target: Target) -> float:
    """Return by how much a number moves a target; a period counts by how evenly it is met and missed."""
    if target.measure is Measure.PERIOD:
        share = float(scan.regular.mean())
        return share * (1 - share)
    return float(np.ptp(scan.logs[:, at]))


def _cost(trial: Trial, scan: Scan, targets: tuple[Target, ...]) -> tuple[int, float]:
    found = margins(trial, targets)
    effort = abs(math.log(trial.values[0] / scan.value))
    return int((found < 0).sum()), EFFORT * effort - min(float(found.min()), AMPLE)


def _places(
    mechanism: Mechanism, missed: tuple[Target, ...], sensitivities: Sensitivities | None
) -> list[tuple[str, str, float]]:
    stepped = is_stepped(each.measure for each in missed)
    every = sorted(designable(mechanism, stepped=stepped), key=lambda each: _order(each[0]))
    asked = [MeasureOfPart(each.measure, each.part) for each in missed if each.measure is not Measure.PERIOD]
    ranked = _interleaved(
        [[e.place for e in sensitivities.ranked(a)] for a in asked] if sensitivities else []
    )
    chosen = [each for each in every if each[0] in ranked[:PLACES]]
    others = [each for each in every if each not in chosen]
    return [*chosen, *others][:PLACES]


def _order(place: str) -> int:
    key = parse_place(place)[-1]
    return FIRST.index(key) if key in FIRST else len(FIRST)


def _interleaved(lists: Sequence[Sequence[str]]) -> list[str]:
    """Return the first of each list, then the second, and so on, each place once."""
    return list(dict.fromkeys(filter(None, itertools.chain(*itertools.zip_longest(*lists)))))


def _factors(place: str, each_side: int) -> Reals:
    """Return the factors by which a number is changed, rising, with 1 in the middle."""
    lowest, highest = OWN.get(parse_place(place)[-1], (1 / FARTHEST, FARTHEST))
    down, up = np.geomspace(lowest, 1.0, each_side + 1), np.geomspace(1.0, highest, each_side + 1)
    return np.concatenate([down, up[1:]])


def _from_the_middle(count: int) -> list[int]:
    middle = count // 2
    return sorted(range(count), key=lambda at: abs(at - middle))
