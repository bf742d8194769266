"""What a motion that has not settled is, as far as the numbers carry it: chaos, a torus, or undecided."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.stretch import Ending
from trimmer.mechanism.drives import RETURNS, told_of_drives
from trimmer.motion.time_scale import is_brief, slowest_met
from trimmer.response.periodic.pace import pace_of, period_word, periods_of
from trimmer.response.results.response import MotionKind, SettledMotion
from trimmer.response.statistics.growth import OLDER, grows
from trimmer.response.statistics.window import Watched, joined, watch
from trimmer.response.statistics.zero_one import growth_of_walk

if TYPE_CHECKING:
    from trimmer.hybrid.stretch import Instant
    from trimmer.motion.flow import Flow
    from trimmer.response.settling.settling import Settling

WINDOW = 512  # Drive periods that a motion is watched at first
MOST_WINDOWS = 4  # By how much the window grows at most while the kind of the motion is undecided
ERRORS = 3.0  # Standard errors by which an exponent has to differ from zero
RESOLVED = 0.05  # Largest modulus of an exponent per drive period, errors included, that is taken for zero
ORDERLY = 0.2  # Largest result of the 0-1 test of a motion on a torus
STEADY = 0.1  # Share by which each half of the window may fall short of the swing of a motion on a torus
NEIGHBOUR = 1e-9  # Distance of the motion that is followed beside the first one, as a share of the sizes
LEAVES = 1e3  # Growth of that distance at which the neighbour has left
SEED = 2  # Of the direction in which that neighbour lies
BESIDE = 256  # Drive periods over which both are followed


def cut_short(settling: Settling, agrees: bool | None) -> SettledMotion:
    """Return what is known of a motion that could not be followed further."""
    if settling.grows:
        told = (
            "It diverges: the drive or a constant force meets what nothing holds or damps, and no event "
            "comes any more, so that it grows for ever."
        )
        return _diverging(settling.periods, told)
    kind, followed = MotionKind.UNDECIDED, periods_of(settling.flow.subject, settling.periods)
    told = f"It could be followed for {followed} only: {settling.ending.value}."
    if settling.ending is Ending.DIVERGED and settling.periods:
        kind = MotionKind.DIVERGING
        told = f"It diverges: after {followed} {settling.ending.value}."
    return SettledMotion(kind, None, None, settling.periods, agrees, told)


def grown(seen: SeenMotion, waited: int) -> SettledMotion:
    """Return what is known of a motion that grows in proportion to its age."""
    periods = waited + seen.window.periods
    told = (
        f"It diverges: after {periods_of(seen.flow.subject, periods)} it had not settled, and until "
        f"{OLDER * periods} it grew in proportion to the time or faster; nothing that it met held it."
    )
    return _diverging(OLDER * periods, told)


def _diverging(periods: int, told: str) -> SettledMotion:
    return SettledMotion(MotionKind.DIVERGING, None, None, periods, None, told)


def unsettled(seen: SeenMotion, waited: int, agrees: bool | None) -> SettledMotion:
    """Return what is known of a motion that has not settled after a wait and was watched since."""
    periods = waited + seen.window.periods
    told = _told(seen, waited, agrees)
    return SettledMotion(seen.kind, None, seen.window, periods, agrees, told)


def look_closely(flow: Flow, instant: Instant) -> SeenMotion | None:
    """Watch a motion until it is known what it is, or for some windows; None if it ends at once."""
    periods = WINDOW * pace_of(flow.subject)
    window = watch(flow, instant, periods)
    if window is None:
        return None
    seen = SeenMotion(flow, window, _neighbour_leaves(flow, window))
    for _ in range(MOST_WINDOWS - 1):
        decided = seen.kind is not MotionKind.UNDECIDED or seen.contracts
        more = None if decided else watch(seen.window.flow, seen.window.end, periods)
        if more is None:
            break
        seen = replace(seen, window=joined(seen.window, more))
    return seen


@dataclass(frozen=True, eq=False)
class SeenMotion:
    """What was seen of a motion that has not settled."""

    flow: Flow  # The motion of the mechanism
    window: Watched  # The motion over some drive periods
    leaves: bool  # Whether a neighbouring motion leaves it

    def grows(self, waited: int) -> bool:
        """Say whether it grows in proportion to its age, after some drive periods and the window."""
        return grows(self.window.flow, self.window.end, self.window.states, waited + self.window.periods)

    @property
    def contracts(self) -> bool:
        """Whether all small distances shrink, so that it will settle."""
        largest = self.window.exponents[0]
        return not self.leaves and largest.value + ERRORS * largest.uncertainty < 0

    @property
    def kind(self) -> MotionKind:
        """What it is, as far as the numbers carry it."""
        largest = self.window.exponents[0]
        error = ERRORS * largest.uncertainty
        if largest.value - error > 0:
            return MotionKind.CHAOTIC if self.leaves else MotionKind.UNDECIDED
        if self.contracts and not self.flow.modes.system.layout.recurrence:
            return MotionKind.TORUS
        zero = abs(largest.value) <= error and abs(largest.value) + error < RESOLVED
        return (
            MotionKind.TORUS
            if zero and not self.leaves and self.moves and self.steady and self.orderly
            else MotionKind.UNDECIDED
        )

    @property
    def moves(self) -> bool:
        """Whether something moves; not where all sticks while an integral runs on."""
        displacements = self.flow.modes.system.layout.kinds[0]
        return bool(np.ptp(self.window.states[:, displacements], axis=0).any())

    @property
    def steady(self) -> bool:
        """Whether the states swing in each half of the window as in all of it, and do not drift."""
        states = self.window.states
        halves = np.min([np.ptp(half, axis=0) for half in np.array_split(states, 2)], axis=0)
        return bool((halves >= (1 - STEADY) * np.ptp(states, axis=0)).all())

    @property
    def orderly(self) -> bool:
        """Whether the 0-1 test calls the displacements orderly, seen once a drive period."""
        layout = self.flow.modes.system.layout
        rates = {place for rate in layout.rates for place in range(rate.start, rate.stop)}
        places = [at for kind in layout.kinds for at in range(kind.start, kind.stop) if at not in rates]
        states = self.window.states[:: pace_of(self.flow.subject), places]
        return all(growth_of_walk(series) < ORDERLY for series in states.T)


def _neighbour_leaves(flow: Flow, window: Watched) -> bool:
    begin = window.begin
    direction = np.random.default_rng(SEED).normal(size=flow.size)
    step = NEIGHBOUR * window.sizes * direction / np.linalg.norm(direction)
    beside = flow.at(begin.state + step, begin.phase, like=begin)
    first, second = (flow.reduced(flow.strobe(each, BESIDE).states) for each in (begin, beside))
    count = min(len(first), len(second))
    apart = np.linalg.norm((first[:count] - second[:count]) / window.sizes, axis=1)
    return bool(apart.max() > LEAVES * NEIGHBOUR)


def _told(seen: SeenMotion, waited: int, agrees: bool | None) -> str:
    largest = seen.window.exponents[0]
    exponent = f"{largest.value:.3g} +- {largest.uncertainty:.1g} per {period_word(seen.flow.subject)}"
    if seen.kind is MotionKind.TORUS and seen.contracts:
        return (
            f"It runs on a torus: {told_of_drives(RETURNS)}. After {waited} of them all small distances "
            f"shrink, so that it follows the drives (largest Lyapunov exponent {exponent}); figures are "
            f"those of {seen.window.periods} periods."
        )
    kinds = {
        MotionKind.CHAOTIC: "It is chaotic",
        MotionKind.TORUS: "It seems to run on a torus",
        MotionKind.UNDECIDED: "It is undecided what it settles to",
    }
    told = (
        f"{kinds[seen.kind]}: it had not settled after {periods_of(seen.flow.subject, waited)}, and over "
        f"{seen.window.periods} more its largest Lyapunov exponent is {exponent}; a neighbouring motion "
        f"{'leaves it' if seen.leaves else 'stays near it'}."
    )
    if seen.kind is MotionKind.CHAOTIC:
        told += (
            f" Chaos over {periods_of(seen.flow.subject, waited + seen.window.periods)} may still be a "
            "transient that ends."
        )
    if seen.kind is MotionKind.UNDECIDED and is_brief(seen.flow, waited * seen.flow.period):
        slowest = periods_of(seen.flow.subject, round(slowest_met(seen.flow) / seen.flow.period))
        told += f" Its slowest mode takes {slowest}, so that this was brief: --periods waits longer."
    if agrees is None:
        return told
    return told + f" A start a little beside this one {'does not settle either' if agrees else 'settles'}."
