"""Every number of simulated motions that claims and figures need, solved once."""

from dataclasses import dataclass

from report.numbers.drive_amplitudes import (
    AmplitudeRun,
    ReferenceNumbers,
    solve_drive_amplitudes,
    solve_reference,
)
from report.numbers.driven_motion import DrivenNumbers, solve_driven
from report.numbers.exact_orbits import ExactOrbits, solve_orbits
from report.numbers.impulse_response import ImpulseNumbers, solve_impulses
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.printed_friction import PrintedFriction, solve_printed_friction
from report.numbers.relay_loop import RelayNumbers, solve_relay
from report.numbers.released_bodies import ReleasedBodiesNumbers, solve_released_bodies
from report.numbers.released_motion import ReleasedNumbers, solve_released
from report.numbers.timed_block import TimedBlockNumbers, solve_timed_block
from trimmer import pin_model
from trimmer.linear import InputChannels


@dataclass(frozen=True, eq=False)
class ClosedLoopNumbers:
    """The loops of section 5.2 in exact motion."""

    orbits: ExactOrbits  # Limit cycles
    impulses: ImpulseNumbers  # After an impulse
    reference: ReferenceNumbers  # With a sinusoidal reference
    # Inertia-controlled backlash behind a drive, and Listing A.8's block in a loop
    timed_block: TimedBlockNumbers
    released_bodies: ReleasedBodiesNumbers  # With the gap and the friction of figure 5.23, released
    relay: RelayNumbers  # With a relay or friction alone


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


@dataclass(frozen=True, eq=False)
class MotionNumbers:
    """Exact motions of the trimmer with the parameters of Listing A.1."""

    driven: DrivenNumbers  # Open loop, driven by the pin (chapter 3)
    released: ReleasedNumbers  # Closed loop, released without drive (chapter 3 and appendix E)
    printed_friction: PrintedFriction  # Friction with the sign of equation 3.2
    # Open loop with drives of different amplitude (appendix E), in rising order
    drive_amplitudes: tuple[AmplitudeRun, ...]
    closed: ClosedLoopNumbers  # The loops of section 5.2


def solve_motion(numbers: LinearNumbers, cycles: LimitCycleNumbers) -> MotionNumbers:
    """Simulate everything with one set of parameters."""
    parameters = numbers.parameters
    return MotionNumbers(
        driven=solve_driven(parameters),
        released=solve_released(parameters),
        printed_friction=solve_printed_friction(parameters),
        drive_amplitudes=solve_drive_amplitudes(
            pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
        ),
        closed=solve_closed_loops(numbers, cycles),
    )
