"""The describing function of friction-controlled play, told by its phase lag: one value for one lag."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash

PLAY = FrictionBacklash(1.0)  # Play of gap 1: with another gap the amplitude is as many times larger
CELLS = 4096
"""Of a table over the lag; with it a solution is only enclosed, and then computed by Newton's method."""


@dataclass(frozen=True)
class GainByLag:
    """ln |N|, (cells + 1,), and u = gap / amplitude at even lags, from 0 (no play) to a quarter turn.

    The lag rises all the way as the amplitude falls, to half the gap, and the modulus falls, so either
    tells the other.
    """

    log_gain: Reals
    u: Reals

    def log_gain_at(self, lags: Reals) -> Reals:
        """Return ln |N| at lags, rad, of any shape; beyond the ends that of the ends."""
        return _between(self.log_gain, lags)

    def u_at(self, lags: Reals) -> Reals:
        """Return gap / amplitude at lags, rad, of any shape; beyond the ends that of the ends."""
        return _between(self.u, lags)


def _between(table: Reals, lags: Reals) -> Reals:
    place = np.clip(lags * (CELLS / (0.5 * np.pi)), 0.0, CELLS - 1e-9)
    cell = place.astype(np.intp)
    low = table[cell]
    return np.asarray(low + (place - cell) * (table[cell + 1] - low))


@cache
def gain_by_lag() -> GainByLag:
    """Return the table of the describing function over its lag."""
    # The lag is nearly proportional to u at small u, and to the root of 2 - u near the other end.
    u = 2.0 * np.sin(np.linspace(0.0, 0.5 * np.pi, 16 * CELLS + 1)[1:-1]) ** 2
    gains = PLAY.describing_function(1.0 / u)
    lags = -np.angle(gains)
    if not (np.diff(lags) > 0).all():
        raise ArithmeticError("the lag of play does not rise as the amplitude falls")
    wanted = np.linspace(0.0, 0.5 * np.pi, CELLS + 1)
    log_gain = np.interp(wanted, lags, np.log(np.abs(gains)))
    log_gain[0] = 0.0
    return GainByLag(log_gain, np.interp(wanted, [0.0, *lags, 0.5 * np.pi], [0.0, *u, 2.0]))
