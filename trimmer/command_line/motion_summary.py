"""What is told of any simulated motion: its events counted, and amplitudes at its end."""

from collections import Counter
from collections.abc import Iterable, Mapping

import numpy as np

from trimmer.arrays import Reals

SHARE = 0.1  # Part of the duration, at the end of the motion, that the summary describes
POINTS = 20_001


def summary_lines(duration: float, ending: str, events: Iterable[tuple[str, str]]) -> list[str]:
    """Return the first lines of a summary: duration, s, how it ended, how often each part had what event."""
    counts = Counter(events)
    return [
        f"Motion of {duration:.6g} s: {ending}",
        *(f"  {part}: {number} x {kind}" for (part, kind), number in sorted(counts.items())),
        *([] if counts else ["  no event: the motion is linear"]),
        f"The last {SHARE:.0%} of it, half of peak to peak:",
    ]


def last_times(duration: float) -> Reals:
    """Return times at the end of a motion, s, (``POINTS``,)."""
    return np.minimum(np.linspace((1.0 - SHARE) * duration, duration, POINTS), duration)


def amplitudes(signals: Mapping[str, Reals]) -> dict[str, float]:
    """Return half of peak to peak of signals."""
    return {name: 0.5 * float(np.ptp(values)) for name, values in signals.items()}
