"""How far 1/G from its poles and zeros is off that of the system they were computed from.

Roots of a polynomial may be ill-determined while their product along the imaginary axis is not: of
1/(s + 1)**18 they lie on a circle round -1, and 1/G is right to 13 digits. So what is compared is 1/G, where
roots are near. For a transfer function what its coefficients' last digits may change there is added.
"""

import control
import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.linear_part import LinearGain

_EPSILON = float(np.finfo(float).eps)

_BESIDE_AXIS_ROOT = 1e-4
"""Distance, relative, from a root on the axis within which nothing is compared: there it alone counts."""


def factoring_error(system: control.lti.LTI, linear: LinearGain, response: InverseResponse) -> float:
    """Bound how far 1/G + linear in factors is off, relative, at its roots and between them.

    To the largest error found comes, for a transfer function, what one digit in the last place of each
    coefficient may change. It is infinite where that cannot be told.
    """
    omegas = _telling_frequencies(response)
    if omegas.size == 0:
        return 0.0
    with np.errstate(all="ignore"):
        inverse, log_unit, rounding = _inverse(system, omegas)
        if linear != LinearGain():
            unit, added = np.exp(log_unit), linear.value(omegas)
            inverse, rounding = unit * inverse + added, unit * rounding + _EPSILON * np.abs(added)
            log_unit = np.zeros(omegas.shape)
        x = np.log(omegas)
        factored = response.direction(x) * np.exp(response.log_size(x) - log_unit)
        error = (np.abs(factored - inverse) + rounding) / np.abs(inverse)
    return float(np.where(np.isnan(error), np.inf, error).max())


def _inverse(system: control.lti.LTI, omegas: Reals) -> tuple[Complexes, Reals, Reals]:
    """Evaluate 1/G as it is given, in a unit for each omega: value, ln of the unit, and bound of rounding."""
    if isinstance(system, control.TransferFunction):
        (above, log_above, lost), (below, log_below, lost_below) = (
            _side(side[0][0], omegas) for side in (system.den, system.num)
        )
        size = np.abs(below)
        return above / below, log_above - log_below, (lost + np.abs(above) / size * lost_below) / size
    distances = 1j * omegas[:, None, None] * np.eye(system.nstates) - system.A
    try:
        states = np.linalg.solve(distances, np.broadcast_to(system.B, (omegas.size, *system.B.shape)))
    except np.linalg.LinAlgError:
        states = np.full((omegas.size, *system.B.shape), np.nan)
    value = (system.C @ states)[:, 0, 0] + system.D[0, 0]
    size = np.abs(value)
    return size / value, -np.log(size), np.zeros(omegas.shape)


def _telling_frequencies(response: InverseResponse) -> Reals:
    """Frequencies of the roots, rad/s, by modulus and by imaginary part, and between those."""
    roots = response.roots
    places = np.unique(np.concatenate([np.abs(roots), np.abs(roots.imag)]))
    places = places[places > 0]
    places = np.concatenate([places, np.sqrt(places[1:]) * np.sqrt(places[:-1])])
    on_axis = np.abs(roots.imag[(roots.real == 0) & (roots.imag != 0)])
    near = (np.abs(places - on_axis[:, None]) <= _BESIDE_AXIS_ROOT * places).any(axis=0)
    return np.asarray(places[~near] * response.reference)


def _side(coefficients: Reals, omegas: Reals) -> tuple[Complexes, Reals, Reals]:
    """Evaluate a polynomial at j omega as mantissas and powers of two, so that no term overflows."""
    rising = np.trim_zeros(np.asarray(coefficients, dtype=float), "f")[::-1]
    powers = np.arange(rising.size)
    mantissas, exponents = np.frexp(rising)
    base, octaves = np.frexp(omegas[:, None])
    octaves = exponents + octaves * powers
    octaves[:, mantissas == 0] = np.iinfo(octaves.dtype).min // 2
    most = octaves.max(axis=1, keepdims=True)
    terms = np.ldexp(mantissas * base**powers, np.maximum(octaves - most, -2000))
    value = terms @ np.array([1.0, 1.0j, -1.0, -1.0j])[powers % 4]
    return value, np.log(2.0) * most[:, 0], rising.size * _EPSILON * np.abs(terms).sum(axis=1)
