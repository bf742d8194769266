"""Newton's method on N + 1/G = 0 from enclosures of many trimmers, and what the derivatives tell."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import ArrayRecord, Complexes, Flags, Reals
from trimmer.balance.uniqueness import cross
from trimmer.ensembles.crossings import Crossings
from trimmer.ensembles.gain_by_phase import PLAY
from trimmer.ensembles.responses import Responses

STEPS = 8
ROUNDING = 1e-11  # Residual |N + 1/G| / |N| up to which a solution counts as found
SLACK = 1e-6  # How far, as a share of the frequency, a solution may lie outside of its enclosure


@dataclass(frozen=True, eq=False)
class CycleSolutions(ArrayRecord):
    """Solutions of harmonic balance, each of shape (m,)."""

    omega: Reals  # In units of the references
    u: Reals  # gap / amplitude
    gain: Complexes  # N
    sine: Reals  # Of the angle between the curves; positive if Loeb's criterion holds
    residual: Reals  # |1 + N G|
    found: Flags  # Whether Newton's method ended within the enclosure


def polished(responses: Responses, crossings: Crossings) -> CycleSolutions:
    """Find the solution within each of m enclosures."""
    x, u = np.log(0.5 * (crossings.lower + crossings.upper)), crossings.u.copy()
    for _ in range(STEPS):
        inverse, by_x = responses.inverse_and_slope(x)
        gain, by_u, _ = PLAY.expansion(1.0 / u)
        rest = gain - inverse
        determinant = cross(by_u, -by_x)
        with np.errstate(all="ignore"):
            step_u, step_x = cross(-rest, -by_x) / determinant, cross(by_u, -rest) / determinant
        # A step that would leave the amplitudes that exist is shortened.
        u = np.where(np.isfinite(step_u), np.clip(u + step_u, 0.5 * u, 0.5 * (u + 2.0)), u)
        x = x + np.where(np.isfinite(step_x), np.clip(step_x, -0.1, 0.1), 0.0)
    inverse, by_x = responses.inverse_and_slope(x)
    gain, by_u, _ = PLAY.expansion(1.0 / u)
    omega = np.exp(x)
    residual = np.abs(gain - inverse) / np.abs(inverse)
    # u falls as the amplitude rises, and 1/G is the negative of the inverse here.
    sine = cross(-by_u, -by_x) / (np.abs(by_u) * np.abs(by_x))
    inside = (omega > crossings.lower * (1 - SLACK)) & (omega < crossings.upper * (1 + SLACK))
    return CycleSolutions(omega, u, gain, sine, residual, inside & (residual < ROUNDING))
