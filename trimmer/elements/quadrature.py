"""A harmonic of an output over half a period, by adaptive quadrature with an estimate of its error.

Each panel is integrated by the 15 points of Kronrod. The estimate of the error is what the polynomial through
every other one of them misses at the rest, and that through all of them next to the ends, times the width on
which it may be missed: a kink or a jump shows in that wherever it lies. Panels are halved where it is too
large. The first ones get narrower towards the peak of the input, where an element may act briefly.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Reals

TOLERANCE = 1e-13  # Error of a panel, over the largest output, below which it is not halved
MOST_LEVELS = 50  # How often a panel is halved: to the last digit
MOST_PANELS = 4000  # Panels at one level above which none is halved any more; the estimate of the error tells
_EVEN = 8
_TOWARDS_PEAK = 2.0 ** -np.arange(1, 17)

_KRONROD_NODES = np.array(
    [
        0.991455371120812639206854697526329,
        0.949107912342758524526189684047851,
        0.864864423359769072789712788640926,
        0.741531185599394439863864773280788,
        0.586087235467691130294144691693013,
        0.405845151377397166906606412076961,
        0.207784955007898467600689403773245,
        0.0,
    ]
)
_KRONROD_WEIGHTS = np.array(
    [
        0.022935322010529224963732008058970,
        0.063092092629978553290700663189204,
        0.104790010322250183839876322541518,
        0.140653259715525918745189590510238,
        0.169004726639267902826583426598550,
        0.190350578064785409913256402421014,
        0.204432940075298892414161999234649,
        0.209482141084727828012999174891714,
    ]
)
NODES = np.concatenate([-_KRONROD_NODES, _KRONROD_NODES[-2::-1]])
WEIGHTS = np.concatenate([_KRONROD_WEIGHTS, _KRONROD_WEIGHTS[-2::-1]])
ENDS = np.array([-1.0, 1.0]) * (1.0 - 1e-9)
"""Places next to the ends of a panel, beyond its outermost points; just inside, as outputs may jump there."""
END_ZONE = 0.01  # More than the distance of the outermost points from the ends, over half the width
BETWEEN = 0.21  # More than the distance between two points, over half the width
COARSE = slice(1, 15, 2)
OTHERS = slice(0, 15, 2)


def _continuation(known: Reals, wanted: Reals) -> Reals:
    """Return the matrix that continues values at some places to others, by the polynomial through them."""
    apart = known[:, None] - known
    np.fill_diagonal(apart, 1.0)
    terms = 1.0 / apart.prod(axis=1)[:, None] / (wanted - known[:, None])
    return np.asarray(terms / terms.sum(axis=0))


TO_ENDS = _continuation(NODES, ENDS)
TO_OTHERS = _continuation(NODES[COARSE], NODES[OTHERS])
PLACES = np.concatenate([NODES, ENDS])


class QuadratureEstimate(NamedTuple):
    """A describing function by quadrature.

    Attributes:
        value: N_n, in the unit of output over input.
        error: Estimate of its error, in that unit; it knows what the points of the first panels see.
        odd: Largest sum of outputs half a period apart, over the largest output; 0 for an odd element.
    """

    value: complex
    error: float
    odd: float


def harmonic_by_quadrature(
    halves: Callable[[Reals], tuple[Reals, Reals]],
    amplitude: float,
    harmonic: int,
    breaks: Sequence[float] = (),
) -> QuadratureEstimate:
    """Integrate N_n = (2j/(πA)) ∫ y exp(-jnθ) dθ over half a period, with y the odd part of the output.

    The output is given by phases θ, rad, (n,), there and half a period later; it has kinks or jumps at
    the breaks.
    """
    cuts = _first_cuts(harmonic, breaks)
    begin, end = cuts[:-1], cuts[1:]
    total, error, largest, asymmetry = 0j, 0.0, 0.0, 0.0
    for level in range(MOST_LEVELS + 1):
        half = 0.5 * (end - begin)
        phases = (0.5 * (begin + end))[:, None] + half[:, None] * PLACES
        first, second = (each.reshape(phases.shape) for each in halves(phases.ravel()))
        if level == 0:
            largest = float(max(np.abs(first).max(), np.abs(second).max()))
            asymmetry = float(np.abs(first + second)[:, : NODES.size].max())
        if not (np.isfinite(first).all() and np.isfinite(second).all()):
            return QuadratureEstimate(complex(math.nan, math.nan), math.nan, math.nan)
        integrand = 0.5 * (first - second) * np.exp(-1j * harmonic * phases)
        inner, ends = integrand[:, : NODES.size], integrand[:, NODES.size :]
        fine = (inner * WEIGHTS).sum(axis=1) * half
        # What a polynomial misses at other points, as a kink may leave the difference of two sums small.
        apart = BETWEEN * half * np.abs(inner[:, COARSE] @ TO_OTHERS - inner[:, OTHERS]).max(axis=1)
        apart += END_ZONE * half * np.abs(inner @ TO_ENDS - ends).max(axis=1)
        halved = apart > TOLERANCE * largest
        if level == MOST_LEVELS or np.count_nonzero(halved) > MOST_PANELS:
            halved[:] = False
        total += complex(fine[~halved].sum())
        error += float(apart[~halved].sum())
        if not halved.any():
            break
        middle = 0.5 * (begin + end)[halved]
        begin, end = (np.concatenate([begin[halved], middle]), np.concatenate([middle, end[halved]]))
    factor = 2.0 / (math.pi * amplitude)
    rounding = 1e-15 * math.pi * largest
    return QuadratureEstimate(
        1j * factor * total, factor * (error + rounding), asymmetry / largest if largest else 0.0
    )


def _first_cuts(harmonic: int, breaks: Sequence[float]) -> Reals:
    """Return the ends of the first panels, rad: even ones, narrow ones about the peak, and the breaks."""
    even = np.linspace(0.0, math.pi, _EVEN + 2 * harmonic + 1)
    peak = 0.5 * math.pi * np.concatenate([1.0 - _TOWARDS_PEAK, 1.0 + _TOWARDS_PEAK])
    named = np.mod(np.asarray(breaks, dtype=float), math.pi)
    cuts = np.unique(np.concatenate([even, peak, named[np.isfinite(named)]]))
    return np.asarray(cuts)
