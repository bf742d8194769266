"""Backlash in the time domain: contact on either side, free flight in the gap, and rest in it."""

import math
from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Reals
from trimmer.loops.components.switched_component import (
    Component,
    ComponentFunction,
    EventKind,
    Explicit,
    ModeChange,
    OutputLaw,
    Signals,
)

FREE, UPPER, LOWER, RESTING = range(4)
SETTLED = 2.0**-60  # Share of its velocity that a free load has when it counts as resting: below rounding


@final
@dataclass(frozen=True)
class BacklashComponent(Component):
    """A load M v' + D v = 0 behind a gap, pushed by the pin on either side; impacts are plastic.

    In contact the load is at pin -+ gap/2, as long as the pin need not pull: tau a + v >= 0 on the upper
    side, with the pin's velocity v, acceleration a and tau = M/D. Free, the load slows down with tau, stops
    at once for tau = 0 (friction-controlled), or keeps its velocity for tau = oo (inertia-controlled). It is
    the motion that derivations/elements/backlash.py derives the describing function from.

    A load that has slowed down to rounding, after 42 tau, rests in a mode of its own, where tau no longer
    limits the steps: so the motion costs the same for any tau, however small.
    """

    gap: float  # Total clearance, > 0, m
    time_constant: float  # tau = M/D of the load, s; 0 and infinity are the two limits

    name = "backlash"  # Name of the component in events: backlash
    mode_names = ("free", "upper contact", "lower contact", "at rest in the gap")
    """Names of the modes by number: ``FREE``, ``UPPER``, ``LOWER``, ``RESTING``."""

    @property
    def slows_down(self) -> bool:
        """Whether the velocity of a free load decays at a finite rate."""
        return 0.0 < self.time_constant < math.inf

    @property
    def state_count(self) -> int:
        """Number of states of a free load: position, velocity if any, and the share of it that remains."""
        return 3 if self.slows_down else 2 if self.time_constant > 0 else 1

    @property
    def state_names(self) -> tuple[str, ...]:
        """Position, velocity and the share of it that remains, as far as there are such."""
        return ("position", "velocity", "share of velocity")[: self.state_count]

    def mirrored(self, mode: int) -> int:
        """Return the mode of the mirrored motion: the contacts change places, the others stay."""
        return (FREE, LOWER, UPPER, RESTING)[mode]

    @property
    def even_states(self) -> int:
        """One if the load slows down, else none: the share of the velocity that remains keeps its sign."""
        return 1 if self.slows_down else 0

    def output_law(self, mode: int) -> OutputLaw:
        """Return the position of the load, m: a state of its own in the gap, pin -+ gap/2 in contact."""
        if mode in (FREE, RESTING):
            return Explicit(0.0, (1.0,) + (0.0,) * (self.state_count - 1), 0.0)
        half_gap = 0.5 * self.gap
        return Explicit(1.0, (0.0,) * self.state_count, -half_gap if mode == UPPER else half_gap)

    def state_rates(self, mode: int) -> Reals:
        """Return the matrix of free flight, 1/s; in contact the own states rest, unused."""
        rates = np.zeros((self.state_count, self.state_count))
        if mode == FREE and self.time_constant > 0:
            rates[0, 1] = 1.0
            for decaying in range(1, self.state_count if self.slows_down else 0):
                rates[decaying, decaying] = -1.0 / self.time_constant
        return rates

    def switching_function(self, signals: Signals) -> Reals:
        """Return the contact force on the upper side over D (m/s), or over M (m/s²) if M/D exceeds 1 s."""
        if self.time_constant > 1.0:
            return signals.input_curvature + signals.input_rate / self.time_constant
        return self.time_constant * signals.input_curvature + signals.input_rate

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[ComponentFunction, ...]:
        """Return the clearances to both sides in the gap, the contact force in contact."""
        if mode == RESTING:
            return self._clearances(signals)
        if mode == FREE:
            return self._clearances(signals) + (self._rest(signals) if self.slows_down else ())
        nothing = 0.0 * signals.one
        velocity = signals.input_rate if self.time_constant > 0 else nothing
        resets = (signals.output, velocity, signals.one)[: self.state_count]
        # At separation position and velocity agree; so do accelerations where the contact force was zero.
        reached, jumped = (3, 2) if self.time_constant > 0 else (2, 1)
        upper = mode == UPPER
        force = self.switching_function(signals) if upper else -self.switching_function(signals)
        leave, leave_at_once = (
            ModeChange(EventKind.SEPARATION, FREE, resets, (zeros, 0) if upper else (0, zeros))
            for zeros in (reached, jumped)
        )
        return (ComponentFunction(force, leave, leave_at_once),)

    def _clearances(self, signals: Signals) -> tuple[ComponentFunction, ...]:
        half_gap = 0.5 * self.gap * signals.one
        play = signals.input - signals.output
        nothing = 0.0 * signals.one
        stop = (signals.states[0], nothing, nothing) if self.slows_down else ()
        meet_upper, meet_lower = (ModeChange(EventKind.IMPACT, side, stop, (0,)) for side in (UPPER, LOWER))
        return (
            ComponentFunction(half_gap - play, meet_upper, meet_upper, continuous=1),
            ComponentFunction(half_gap + play, meet_lower, meet_lower, continuous=1),
        )

    def _rest(self, signals: Signals) -> tuple[ComponentFunction, ...]:
        """Return the event function that ends a flight where the velocity is lost in rounding."""
        position, velocity, share = signals.states
        nothing = 0.0 * signals.one
        resets = (position + self.time_constant * velocity, nothing, nothing)
        rest = ModeChange(EventKind.REST, RESTING, resets, (0, 0))
        return (ComponentFunction(share - SETTLED * signals.one, rest, rest),)

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start at rest in the gap, or in contact where the requested output, m, would lie outside of it."""
        mode, position = RESTING if self.slows_down else FREE, output
        if input_value - output > 0.5 * self.gap:
            mode, position = UPPER, input_value - 0.5 * self.gap
        elif input_value - output < -0.5 * self.gap:
            mode, position = LOWER, input_value + 0.5 * self.gap
        return mode, np.array([position, 0.0, 0.0][: self.state_count])

    def resumed(self, input_value: float, switching_value: float, own: Reals) -> int:
        """Go on in contact where the load would lie outside the gap, else in flight, or at rest in it."""
        mode = super().resumed(input_value, switching_value, own)
        return FREE if mode == RESTING and own[2] > SETTLED else mode
