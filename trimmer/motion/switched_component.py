"""What a switched element is in the time domain: modes, output laws, event functions and transitions.

All signals of a mode are rows: linear functionals of the extended state (states of the plant, states of the
components, sine and cosine of the drive, and one). An event function is positive while its mode lasts.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals


class EventKind(Enum):
    """What happens at an event."""

    IMPACT = "impact"
    """The pin meets a side of the gap."""
    SEPARATION = "separation"
    """The contact would have to pull, so the pin leaves the side of the gap."""
    REST = "rest"
    """A load in the gap has slowed down to rounding, which only matters to the computation; never listed."""
    SWITCH = "switch"
    """The output of a relay, or the direction of sliding, reverses."""
    STICK = "stick"
    """Sliding ends: the output takes the value that holds the input at zero."""
    SLIP = "slip"
    """The output that would hold the input at zero exceeds its limit."""


@dataclass(frozen=True)
class Explicit:
    """The output is input_gain * input + own states weighted by state_gains + constant."""

    input_gain: float
    state_gains: tuple[float, ...]
    constant: float


@dataclass(frozen=True)
class RateProportional:
    """The output is a coefficient times the rate of the input."""

    coefficient: float


@dataclass(frozen=True)
class Constrained:
    """The output is what keeps the switching function at zero: a set-valued element on its vertical part."""


OutputLaw = Explicit | RateProportional | Constrained


@dataclass(frozen=True)
class Signals:
    """Rows of one component in one mode: input, its first two derivatives, output, own states, and one."""

    input: Reals
    input_rate: Reals
    input_curvature: Reals
    output: Reals
    states: tuple[Reals, ...]
    one: Reals


@dataclass(frozen=True)
class Transition:
    """Where an event function leads.

    Attributes:
        kind: What happens.
        target: Mode of the component afterwards.
        resets: New values of the component's states, rows of the mode that is left; empty if they stay.
        zeros: For each event function of the target mode: how many of its first derivatives, counting the
            zeroth, are known to vanish right after the transition.
    """

    kind: EventKind
    target: int
    resets: tuple[Reals, ...]
    zeros: tuple[int, ...]


@dataclass(frozen=True)
class EventFunction:
    """A row that is positive while the mode lasts.

    Attributes:
        row: The functional.
        reached: What follows when it falls to zero.
        jumped: What follows when it is negative at once, because the output of another component jumped, or
            because the mode that was entered cannot hold.
        continuous: How many of its first derivatives, counting the zeroth, do not jump when the output of
            another component does.
    """

    row: Reals
    reached: Transition
    jumped: Transition
    continuous: int = 0


class Component(ABC):
    """One switched element of the interconnection; immutable.

    What has a default holds for a component without states and modes.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """What it is called in events."""

    @property
    def mode_names(self) -> tuple[str, ...]:
        """Names of the modes, by number."""
        return ("always",)

    @property
    def state_count(self) -> int:
        """Number of own states."""
        return 0

    @property
    def output_jumps(self) -> bool:
        """Whether the output can jump while the input does not."""
        return False

    @property
    def continuous_rates(self) -> int:
        """How many derivatives of the input, besides the input itself, must not jump."""
        return 0

    def mirrored(self, mode: int) -> int:
        """Return the mode that takes the place of one when input, states and output change their signs."""
        return mode

    @property
    def even_states(self) -> int:
        """Number of own states, the last ones, that keep their signs then."""
        return 0

    @abstractmethod
    def output_law(self, mode: int) -> OutputLaw:
        """Return how the output follows in a mode."""

    def state_rates(self, mode: int) -> Reals:
        """Return the matrix that gives the rates of the own states from themselves."""
        return np.zeros((self.state_count, self.state_count))

    def switching_function(self, signals: Signals) -> Reals:
        """Return the row that a constrained output holds at zero, or whose sign selects the first mode."""
        return signals.input

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[EventFunction, ...]:
        """Return the event functions of a mode; ``attracting``: whether a constrained output can hold."""
        return ()

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Return the mode and own states to start from, with the output that is wished for."""
        return 0, np.zeros(self.state_count)
