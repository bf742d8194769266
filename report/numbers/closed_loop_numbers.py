"""Every number of section 5.2 that rests on simulation, solved once."""

from __future__ import annotations

from dataclasses import dataclass

from report.numbers.exact_orbits import ExactOrbits, solve_orbits
from report.numbers.impulse_response import ImpulseNumbers, solve_impulses
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.reference_loop import ReferenceNumbers, solve_reference
from report.numbers.relay_loop import RelayNumbers, solve_relay
from report.numbers.released_bodies import ReleasedBodiesNumbers, solve_released_bodies
from report.numbers.timed_block import TimedBlockNumbers, solve_timed_block
from trimmer.linear.model import InputChannels, pin_model


@dataclass(frozen=True, eq=False)
class ClosedLoopNumbers:
    """The loops of section 5.2 in exact motion.

    Attributes:
        orbits: Limit cycles.
        impulses: After an impulse.
        reference: With a sinusoidal reference.
        timed_block: Inertia-controlled backlash behind a drive, and Listing A.8's block in a loop.
        released_bodies: With the gap and the friction of figure 5.23, released.
        relay: With a relay or friction alone.
    """

    orbits: ExactOrbits
    impulses: ImpulseNumbers
    reference: ReferenceNumbers
    timed_block: TimedBlockNumbers
    released_bodies: ReleasedBodiesNumbers
    relay: RelayNumbers


def solve_closed_loops(numbers: LinearNumbers, cycles: LimitCycleNumbers) -> ClosedLoopNumbers:
    """Solve everything for one set of parameters."""
    system = pin_model(numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    orbits = solve_orbits(numbers, cycles)
    return ClosedLoopNumbers(
        orbits=orbits,
        impulses=solve_impulses(system),
        reference=solve_reference(orbits.friction.stable, orbits.friction_both_channels.stable),
        timed_block=solve_timed_block(system),
        released_bodies=solve_released_bodies(numbers.parameters),
        relay=solve_relay(system),
    )
