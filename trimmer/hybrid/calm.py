"""Where in its period a motion had better begin: where nothing happens for as long as can be.

The map of a period is smooth in its state only as long as no event comes to the instant at which the period
begins: there the event changes from the end of one passage to the beginning of the next, and the derivative
changes with it, though the motion and its multipliers do not. What is solved for has an instant of its own.
"""

import numpy as np

from trimmer.arrays import Reals

LEAST_SHARE = 0.3
"""Length of the segment in which motions begin, as a share of the longest, below which they begin there."""
LEAST_MARGIN = 0.15  # Share of a segment from its ends within which no motion begins


def is_amid(starts: Reals, period: float) -> bool:
    """Say whether the time 0 of a period, s, is far from its events, at increasing times, s."""
    own = period - starts[-1] + starts[0]
    longest = max(own, float((starts[1:] - starts[:-1]).max(initial=0.0)))
    share = float(period - starts[-1]) / own if own > 0.0 else 0.0
    return own > LEAST_SHARE * longest and LEAST_MARGIN < share < 1.0 - LEAST_MARGIN


def amid_longest(starts: Reals, period: float) -> float:
    """Return the middle of the longest segment between the events of a period, s, at increasing times, s."""
    lengths = starts[1:] - starts[:-1]
    own = period - starts[-1] + starts[0]
    if own >= lengths.max(initial=0.0):
        return float((starts[-1] + 0.5 * own) % period)
    first = int(np.argmax(lengths))
    return float(starts[first] + 0.5 * lengths[first])
