"""What forces the states by times: profiles of forces, and references that step, ramp or follow points."""

from dataclasses import dataclass

import numpy as np

from trimmer.mechanism.parts import Row

SOON = 1e-12  # Share of the last time of a profile up to which two times are one


@dataclass(frozen=True)
class Profile:
    """A value that is straight between points."""

    points: tuple[Row, ...]  # Time, s, and value of each
    before: float = 0.0  # The value before the first
    slope: float = 0.0  # The rate after the last

    @property
    def times(self) -> tuple[float, ...]:
        """The times of the points, s."""
        return tuple(float(time) for time, _ in self.points)

    def along(self, time: float) -> tuple[float, float]:
        """Return the value and its rate at a time, s: just after it, at a point."""
        points = np.array(self.points)
        after = int(np.searchsorted(points[:, 0], time + SOON * abs(points[:, 0]).max(), side="right"))
        if after == 0:
            return self.before, 0.0
        begin, value = points[after - 1]
        if after == len(points):
            return float(value + self.slope * (time - begin)), self.slope
        slope = (points[after, 1] - value) / (points[after, 0] - begin)
        return float(value + slope * (time - begin)), float(slope)
