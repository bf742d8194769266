"""The band of frequencies in which samples can be trusted, with the reason of each end."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Band:
    """The band of frequencies in which a signal can be trusted.

    Attributes:
        lowest, highest: Its ends, Hz; 0 and infinity where nothing bounds it.
        lowest_reason, highest_reason: What bounds it there, in words; empty where nothing does.
    """

    lowest: float = 0.0
    highest: float = math.inf
    lowest_reason: str = ""
    highest_reason: str = ""

    def __contains__(self, frequency: float) -> bool:
        return self.lowest <= frequency <= self.highest

    def within(self, other: Band) -> Band:
        """Return what both have in common, each end with the reason of the narrower one."""
        low = self if self.lowest >= other.lowest else other
        high = self if self.highest <= other.highest else other
        return Band(low.lowest, high.highest, low.lowest_reason, high.highest_reason)

    @property
    def sentence(self) -> str:
        """The band and its reasons, without a full stop."""
        if not self.lowest and math.isinf(self.highest):
            return "trusted at all frequencies up to half of the sample rate"
        low = f"from {self.lowest:.4g} Hz ({self.lowest_reason})" if self.lowest else ""
        high = f"up to {self.highest:.4g} Hz ({self.highest_reason})" if math.isfinite(self.highest) else ""
        return f"trusted {' '.join(filter(None, (low, high)))}"


EVERYWHERE = Band()
