"""An instant after which no further piece of work is begun."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass


@dataclass(frozen=True)
class Deadline:
    """An instant after which no further piece of work is begun; what is under way goes on to its own end.

    The times are those of the clock on the wall, as the processes of a cluster share no other.
    """

    begun: float = 0.0  # When the work began, s since 1970
    end: float = math.inf  # The instant, s since 1970; infinite if there is none

    @staticmethod
    def after(seconds: float) -> Deadline:
        """Return the instant after some seconds from now."""
        now = time.time()
        return Deadline(now, now + seconds)

    @property
    def left(self) -> float:
        """Seconds until then; 0 afterwards."""
        return max(self.end - time.time(), 0.0)

    @property
    def passed(self) -> bool:
        """Whether it is over."""
        return self.left == 0

    def share(self, share: float) -> Deadline:
        """Return the instant at which a share of the time is over, 0 < share <= 1."""
        return Deadline(self.begun, self.begun + share * (self.end - self.begun))


NEVER = Deadline()  # No instant: all work is done
