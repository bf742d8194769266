"""What the core asks of whatever moves: its modes, what follows an event, and what holds where several rest.

A system has parts, each with a status. All statuses together are a mode, in which the extended state Z moves
as Z' = M Z: states first, then what forces them, one at the end. A mode lasts while all its event functions
are positive. A part whose switching function has come to zero may be held there, as friction that sticks or a
relay that slides; what several parts do that are at rest at one instant they decide together.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Integers, Places, Reals

ARRIVED, AT_LIMIT, STRUCK = range(3)
"""Event functions of parts that can be held: a switching function has come to zero; what holds is at its
limit; the integral of a switching function is reached, where it is reset. Those that a system has besides
count from ``OWN_ACTIONS``."""
OWN_ACTIONS = 3
NOTHING, HOLD_BEGUN, HOLD_ENDED, REVERSED = range(4)
"""What begins a segment of the motion: nothing that counts; a part is held from then on, is not any more, or
goes the other way. What a system has besides counts from ``OWN_KINDS``."""
OWN_KINDS = 4
JOINTLY = -1  # In place of a part: several that are held
ALL = 99  # In place of a number of derivatives: none of them jumps
NO_STATE = -1  # In place of the place of the decaying state of a part that has none


@dataclass(frozen=True, eq=False)
class EventFunction:
    """A functional that is positive while the mode lasts."""

    owner: int  # The part that it belongs to; ``JOINTLY`` for several
    action: int  # What it means that it falls to zero
    row: Reals  # The functional, (N,)
    # Directions in which parts that are held begin to go, for each part that can be held
    signs: tuple[int, ...] = ()
    # How many of its derivatives, counting the zeroth, do not jump when another part changes
    continuous: int = ALL
    # Of one that is reset: the tables say what follows only as long as its rate is more than its second rate
    # times this, s
    shortest: float = field(default=0.0, kw_only=True)


@dataclass(frozen=True, eq=False)
class ModeEquations:
    """The equations of a mode."""

    statuses: tuple[int, ...]  # Of all parts
    flow: Reals  # The matrix M of Z' = M Z, (N, N)
    functions: tuple[EventFunction, ...]  # The event functions
    hold: Reals  # The state, made to fit what is held, (N, N)
    held: tuple[int, ...]  # The parts that are held
    # Statuses of the mode without states that decay by themselves; its own if there are none
    settled: tuple[int, ...]
    decay: Reals  # Rate at which the state of each part decays by itself, 1/s, 0 for others, (m,)
    # Place and rate of each state that decays by itself or has done so, and counts as zero
    decayed: tuple[tuple[int, float], ...]


@dataclass(frozen=True)
class Transition:
    """What follows an event."""

    statuses: tuple[int, ...]  # Of all parts afterwards
    kind: int  # What it counts as
    # Event functions of the part afterwards, by their actions, of which some derivatives vanish, and how
    # many, counting the zeroth
    zeros: tuple[tuple[int, int], ...] = ()
    # The state afterwards, (N, N), None if it goes on; then it is made to fit what is held
    reset: Reals | None = None


class JointEvent(NamedTuple):
    """An event at which parts at rest decide together what they do."""

    function: EventFunction  # What fell to zero
    jumped: bool  # Whether it was negative at once
    at_rest: Places  # Numbers of the parts whose switching functions are zero
    held: tuple[int, ...]  # Numbers of those held before the instant, which go on being held if they can


@dataclass(frozen=True, eq=False)
class Impulse:
    """A reset of the state that was decided."""

    part: int  # The part that it belongs to
    kind: int  # What it counts as
    state: Reals  # The extended state after it, (N,)


@dataclass(frozen=True, eq=False)
class Decision:
    """What parts do at an instant, decided together."""

    statuses: tuple[int, ...]  # Of all parts afterwards
    zeros: int  # How many derivatives vanish of the switching functions of those that begin to go
    state: Reals  # The extended state, (N,), in which those that rest may be made to rest to the last digit
    impulses: tuple[Impulse, ...] = ()  # Resets before that, in order
    # After resets, what is zero at first: part, action, and how many derivatives vanish
    known: tuple[tuple[int, int, int], ...] = ()


@dataclass(frozen=True)
class Sampler:
    """What reads the state at known times and writes places of it that nothing else moves."""

    sample: float  # Time between samples, s; the first one is at t = 0
    delay: float  # Time after a sample at which what it demanded acts, s; 0 for what acts at samples
    limit: float  # Largest modulus of its demand
    places: tuple[int, ...]  # Where it writes the state
    # Where stands what is to act, and where what acts; twice the same if it acts at once
    acting: tuple[int, int]


class Clockwork(Protocol):
    """What samples a motion."""

    @property
    def samplers(self) -> tuple[Sampler, ...]:
        """The samplers, c, which write up to h places each."""

    def sampling(self, modes: Any, number: int) -> tuple[Reals, Reals]:
        """Return what samplers do in a mode, by its number in ``trimmer.hybrid.tables.Modes``.

        Returns:
            Their demands as functionals, (c, N), and what they write within the limit and beyond it on
            either side, (c, 3, h, N), both of the state just before.
        """

    def summed(self, modes: Any, number: int, largest: Reals) -> Reals:
        """Return how large entries of a state must be to count beside what samplers add to them, or they to.

        Args:
            modes: The modes.
            number: Of a mode.
            largest: How large the entries become, (N,).

        Returns:
            That, (N,); 0 for what samplers do not write.
        """


class Layout(Protocol):
    """Where in the extended state what is."""

    @property
    def size(self) -> int:
        """Number N of entries of the extended state."""

    @property
    def state_count(self) -> int:
        """Number n of states, which come first."""

    @property
    def holding(self) -> slice:
        """The states that samplers write, and that nothing else moves."""

    @property
    def forcing(self) -> int:
        """Number of entries that force the states and are not forced by them."""

    @property
    def period(self) -> float:
        """Period of what forces the states, s; 0 for none."""

    @property
    def ramp(self) -> bool:
        """Whether the time itself forces the states."""

    @property
    def recurrence(self) -> int:
        """Periods after which what forces the states returns together; 0 if it does not."""

    def clock(self, periods: int, phase: float) -> float:
        """Return the time that waves count, s, at a phase, s, after some periods."""

    @property
    def drifts(self) -> bool:
        """Whether each period is forced in a way of its own."""

    @property
    def breaks(self) -> tuple[float, ...]:
        """Times at which what forces the states changes its course, s, rising."""

    def changes_after(self, time: float) -> bool:
        """Say whether something else than waves forces the states differently after a time, s."""

    @property
    def steady(self) -> Reals:
        """The entries that force the states without waves, once nothing else changes, (forcing,)."""

    @property
    def omega(self) -> float:
        """Angular frequency of what forces the states, rad/s; 0 for none."""

    @property
    def orders(self) -> tuple[float, ...]:
        """Multiples of it that occur."""

    @property
    def phasors(self) -> Complexes:
        """Entries that force the states at each order, as real parts of these times exp(i order omega t).

        Array (orders, forcing).
        """

    @property
    def kinds(self) -> tuple[slice, ...]:
        """The states of one kind each, whose sizes may be compared."""

    @property
    def lengths(self) -> Reals:
        """What each state is multiplied by before that, (n,)."""

    @property
    def rates(self) -> tuple[slice, ...]:
        """Those kinds that are rates of others, where that is known."""

    @property
    def measured_between(self) -> bool:
        """Whether states may be small at all events and large between them."""

    @property
    def independent(self) -> Places:
        """Places of the states that may be disturbed by themselves; others follow from them."""

    @property
    def travels(self) -> bool:
        """Whether the frame in which the states are moves."""

    def forcing_at(self, time: float, before: float = 0.0) -> Reals:
        """Return the entries that force the states at a time in a period, s, after whole periods, s."""

    def felt(self, distances: Reals) -> Reals:
        """Return distances of states, (n, columns), without what makes no difference."""

    def sizes(self, states: Reals, duration: float) -> Reals:
        """Return the scale of each state, (n,), from states of a motion, (instants, n), and its length, s."""


class System(Protocol):
    """Anything that is linear between events."""

    @property
    def layout(self) -> Layout:
        """Where in the extended state what is."""

    @property
    def clockwork(self) -> Clockwork | None:
        """What samples the motion at known times; None for nothing."""

    @property
    def part_count(self) -> int:
        """Number of parts."""

    @property
    def kind_count(self) -> int:
        """Number of kinds of what begins a segment."""

    @property
    def action_count(self) -> int:
        """Number of actions that event functions of one part can have."""

    @property
    def decaying_states(self) -> Integers:
        """Places of the states of the first m parts that may decay by themselves, ``NO_STATE`` for none."""

    @property
    def scales(self) -> Reals:
        """Sizes by which it is measured what of these states is negligible, (m,)."""

    def mode(self, statuses: tuple[int, ...]) -> ModeEquations:
        """Return the equations of the mode with given statuses of all parts."""

    def transition(self, mode: ModeEquations, function: EventFunction, jumped: bool) -> Transition | None:
        """Return what follows where an event function falls to zero, or is negative at once.

        None where several parts at rest decide it together.
        """

    def reset(self, mode: ModeEquations, function: EventFunction) -> Reals | None:
        """Return what an event makes of the state, (N, N); None if it goes on."""

    def impulse(self, part: int, kind: int) -> tuple[Reals, Reals] | None:
        """Return what an impulse of a part makes of the state, (N, N), and what falls to zero there, (N,).

        None where what happened to the part was no impulse.
        """

    def terms(self, mode: ModeEquations) -> Reals:
        """Return the sums of the moduli of what the flow of a mode is made of, (N, N)."""

    def decide(self, mode: ModeEquations, state: Reals, event: JointEvent) -> Decision:
        """Return what parts at rest do where an event function falls to zero.

        Raises:
            ArithmeticError: if rounding keeps it from being decided.
        """
