"""A motion as far as it was integrated: the instant at its end, why it ends there, its log."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trimmer.choices import Choice
from trimmer.hybrid.work import Log

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals


class Ending(Choice):
    """Why a motion ends where it does."""

    REACHED_END = "it reached its end"
    CHATTERING = "more events at one instant than can be told apart"
    DIVERGED = "it grew beyond all bounds"
    STEP_LIMIT = "it took more steps than allowed"
    EVENT_LIMIT = "it has more events than allowed"
    INTERRUPTED = "it was interrupted"
    UNDECIDED = "rounding kept dry friction at rest from being decided"


@dataclass(frozen=True, eq=False)
class Instant:
    """All that determines the motion from an instant on."""

    state: Reals  # The states, (n,)
    statuses: tuple[int, ...]  # Of all parts
    periods: int  # Whole periods of what forces the states since the start
    phase: float  # Time since then, s
    # How many derivatives of the event functions of each part are known to vanish, by their actions, (parts,
    # actions)
    zeros: Integers
    negligible: Reals  # Moduli of states that decay by themselves which count as zero, (m,)


@dataclass(frozen=True, eq=False)
class Stretch:
    """A motion over some periods."""

    end: Instant  # The instant at which it ends
    ending: Ending  # Why
    log: Log  # Its segments, timed from its start, if they were to be kept; else those of the end
    states: Reals  # State at the start and after each period, (periods done + 1, n)
    counts: Integers  # Events of each period by kind, (periods begun, kinds)
    steps: int  # Number of steps that it took
    duration: float  # Time from its start to its end, s


class AdvanceInterrupted(KeyboardInterrupt):
    """An interrupt (Ctrl-C) ended an integration; the motion until then."""

    def __init__(self, stretch: Stretch) -> None:
        super().__init__("the integration was interrupted")
        self.stretch = stretch
