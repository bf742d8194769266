"""Whether the loops of many trimmers have unstable poles beside that of the limit cycle."""

import numpy as np

from trimmer.arrays import Complexes, Flags
from trimmer.ensembles.gain_by_phase import PLAY
from trimmer.ensembles.polishing import CycleSolutions
from trimmer.ensembles.polynomials import roots
from trimmer.ensembles.responses import Responses

ROUNDING = 1e-9  # Part of a pole below which its real or imaginary part is taken for rounding


def unstable_others(responses: Responses, poles: Complexes, solutions: CycleSolutions) -> tuple[Flags, Flags]:
    """Say which loops have another unstable pole, and for which that could not be told, each (m,).

    The poles are those of 1 + N G(s) with N frozen that swing with positive frequency, and the real ones
    of the mean (``trimmer.balance.stability``). Those of G are in units of the references, (m, 8).
    """
    top = responses.denominator.astype(complex)
    top[:, 1:] += solutions.gain[:, None] * responses.numerator
    own = 1j * solutions.omega
    near = poles.copy()
    rows = np.arange(len(near))
    near[rows, np.abs(near - own[:, None]).argmin(axis=1)] = own
    values, found = roots(top, near)
    values[rows, np.abs(values - own[:, None]).argmin(axis=1)] = 0.0
    rounding = ROUNDING * np.abs(values)
    swinging: Flags = np.asarray(((values.real > rounding) & (values.imag > rounding)).any(axis=1))
    mean = responses.denominator.copy()
    mean[:, 1:] += PLAY.mean_gain(1.0 / solutions.u)[:, None] * responses.numerator
    # Without a change of sign in its coefficients a polynomial has no positive root (Descartes).
    return swinging, ~found | (mean <= 0).any(axis=1)
