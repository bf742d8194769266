"""How a branch is followed."""

from dataclasses import dataclass

from trimmer.arguments import finite_number, positive_number, whole_number
from trimmer.deadline import NEVER, Deadline


@dataclass(frozen=True)
class FollowSettings:
    """How a branch is followed.

    Attributes:
        most_points: Number of orbits after which to stop.
        largest_step: Largest change of the value between two orbits, as a share of the interval.
        switches: How many times one after another to switch to a branch that parts from the last one.
        bounds: The interval within which to stay, if it is not that of start and stop.
        most_periods: Drive periods to wait for a motion from rest to settle.
        quiet: Whether to show no progress bar.
        deadline: After which no further orbit is solved for.

    Raises:
        WrongTypeError: if one of them has another type.
        ValueError: if one is out of its range.
    """

    most_points: int = 2000
    largest_step: float = 0.01
    switches: int = 1
    bounds: tuple[float, float] | None = None
    most_periods: int = 2000
    quiet: bool = False
    deadline: Deadline = NEVER

    def __post_init__(self) -> None:
        whole_number("most_points", self.most_points, 2)
        whole_number("switches", self.switches, 0)
        whole_number("most_periods", self.most_periods, 1)
        if positive_number("largest_step", self.largest_step) > 1.0:
            raise ValueError(f"largest_step must be a share of the interval, not {self.largest_step!r}")
        for bound in self.bounds or ():
            finite_number("bounds", bound)


DEFAULT = FollowSettings()
