"""Every number of simulated motions that claims and figures need, solved once."""

from __future__ import annotations

from dataclasses import dataclass

from report.numbers.closed_loop_numbers import ClosedLoopNumbers, solve_closed_loops
from report.numbers.drive_amplitudes import AmplitudeRun, solve_drive_amplitudes
from report.numbers.driven_motion import DrivenNumbers, solve_driven
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.printed_friction import PrintedFriction, solve_printed_friction
from report.numbers.released_motion import ReleasedNumbers, solve_released
from trimmer.linear.model import InputChannels, pin_model


@dataclass(frozen=True, eq=False)
class MotionNumbers:
    """Exact motions of the trimmer with the parameters of Listing A.1.

    Attributes:
        driven: Open loop, driven by the pin (chapter 3).
        released: Closed loop, released without drive (chapter 3 and appendix E).
        printed_friction: Friction with the sign of equation 3.2.
        drive_amplitudes: Open loop with drives of different amplitude (appendix E), in rising order.
        closed: The loops of section 5.2.
    """

    driven: DrivenNumbers
    released: ReleasedNumbers
    printed_friction: PrintedFriction
    drive_amplitudes: tuple[AmplitudeRun, ...]
    closed: ClosedLoopNumbers


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
