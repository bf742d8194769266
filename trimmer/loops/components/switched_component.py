"""The interface of a switched element in time: modes, output laws, event functions and transitions.

All signals of a mode are rows: linear functionals of the extended state (states of the plant, states of the
components, sine and cosine of the drive, and one). An event function is positive while its mode lasts.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from enum import Enum
from typing import ClassVar

import numpy as np

from trimmer.arrays import Reals


class EventKind(Enum):
    """Kind of an event; the value is its name in text and JSON."""

    IMPACT = "impact"
    """The pin meets a side of the gap."""
    SEPARATION = "separation"
    """The contact would have to pull, so the pin leaves the side of the gap."""
    REST = "rest"
    """A load in the gap has slowed down to rounding, which only matters to the computation; never listed."""
    SWITCH = "switch"
    """The output of a relay, or the direction of sliding, reverses."""
    CORNER = "corner"
    """The input passes a corner of a saturation or dead zone."""
    STICK = "stick"
    """Sliding ends: the output takes the value that holds the input at zero."""
    SLIP = "slip"
    """The output that would hold the input at zero exceeds its limit."""


@dataclass(frozen=True)
class Explicit:
    """The output is input_gain * input + sum of state_gains * own states + constant."""

    input_gain: float  # Output per input
    state_gains: tuple[float, ...]  # Output per own state, one number for each, or none at all
    constant: float  # In the unit of the output


@dataclass(frozen=True)
class RateProportional:
    """The output is a coefficient times the rate of the input, N s/m for a force of a displacement."""

    coefficient: float


@dataclass(frozen=True)
class Constrained:
    """The output is what keeps the switching function at zero: a set-valued element on its vertical part."""


OutputLaw = Explicit | RateProportional | Constrained


@dataclass(frozen=True)
class Signals:
    """Rows of one component in one mode, each of shape (n,) over the extended state."""

    input: Reals  # The input, m for a displacement
    input_rate: Reals  # Its first derivative, m/s
    input_curvature: Reals  # Its second derivative, m/s²
    output: Reals  # The output
    states: tuple[Reals, ...]  # The own states of the component
    one: Reals  # The constant one


@dataclass(frozen=True)
class ModeChange:
    """Where an event function leads."""

    kind: EventKind  # Kind of the event
    target: int  # Mode of the component afterwards
    # New values of the component's states, rows of the mode that is left; empty if they stay
    resets: tuple[Reals, ...]
    # For each event function of the target mode: how many of its first derivatives, counting the zeroth, are
    # known to vanish right after the transition
    zeros: tuple[int, ...]


@dataclass(frozen=True)
class ComponentFunction:
    """A row that is positive while the mode lasts."""

    row: Reals  # The functional, shape (n,), in any unit: only its sign counts
    reached: ModeChange  # Transition when it falls to zero
    # Transition when it is negative at once, because the output of another component jumped, or because the
    # mode that was entered cannot hold
    jumped: ModeChange
    # How many of its first derivatives, counting the zeroth, do not jump when the output of another component
    # does
    continuous: int = 0


class Component(ABC):
    """One switched element of the interconnection; immutable.

    The defaults are those of a component without own states that does not switch.
    """

    mode_names: ClassVar[tuple[str, ...]] = ("always",)  # Names of the modes, by number
    output_jumps: ClassVar[bool] = False  # Whether the output can jump while the input does not

    @property
    @abstractmethod
    def name(self) -> str:
        """Name of the component in events."""

    @property
    def state_count(self) -> int:
        """Number of own states, which the extended state holds."""
        return 0

    @property
    def state_names(self) -> tuple[str, ...]:
        """What the own states are."""
        return ()

    @property
    def drops(self) -> bool:
        """Whether the output falls where it cannot hold the switching function at zero any more."""
        return False

    @property
    def continuous_rates(self) -> int:
        """How many derivatives of the input, besides the input itself, must not jump."""
        return 0

    def mirrored(self, mode: int) -> int:
        """Return the mode in place of ``mode`` when input, states and output change their signs."""
        return mode

    @property
    def even_states(self) -> int:
        """Number of own states, the last ones, that keep their signs in the mirrored motion."""
        return 0

    @abstractmethod
    def output_law(self, mode: int) -> OutputLaw:
        """Return the law that determines the output in a mode."""

    def state_rates(self, mode: int) -> Reals:
        """Return the matrix A, ``state_count`` square, in z' = A z of the own states z."""
        return np.zeros((self.state_count, self.state_count))

    def switching_function(self, signals: Signals) -> Reals:
        """Return the row that a constrained output holds at zero, or whose sign selects the first mode."""
        return signals.input

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[ComponentFunction, ...]:
        """Return the event functions of a mode; attracting if a constrained output could hold it."""
        return ()

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Return the mode and the own states, (state_count,), for a requested output.

        The switching function, or its first derivative that is not zero, may rule that output out.
        """
        return 0, np.zeros(self.state_count)

    def resumed(self, input_value: float, switching_value: float, own: Reals) -> int:
        """Return the mode to go on in with own states, (state_count,), as they are."""
        return self.initial(input_value, switching_value, float(own[0]) if len(own) else 0.0)[0]
