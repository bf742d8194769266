"""Poles of a loop whose describing function is frozen: the roots of 1 + N G(s)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.inverse_response import InverseResponse

    Complexes = NDArray[np.complex128]


def closed_loop_poles(response: InverseResponse, gains: Complexes) -> Complexes:
    """Find all poles of 1 + N G(s) at each of some N.

    G is a chain of sections: 1/(s - pole) without, then (s - zero)/(s - pole) with a zero. The eigenvalues of
    the chain in a loop are the poles; unlike a polynomial's coefficients its entries are of the size of the
    roots.

    Args:
        response: 1/G.
        gains: N, of shape (n,).

    Returns:
        Poles over ``response.reference``, of shape (n, number of poles).
    """
    poles, without = response.poles, response.relative_degree
    first = max(without - 1, 0)
    output = np.ones(poles.size, dtype=complex)
    output[:first] = 0.0
    output[without:] = poles[without:] - response.zeros
    # A section with a zero takes all that the ones before it add to the output, one without only the last.
    place = np.arange(poles.size)
    chain = (place[:, None] > place) * output
    chain[place[1:without], place[:first]] = 1.0
    chain[place, place] = poles
    feedback = gains / response.gain
    if without == 0:
        # Where the difference vanishes a pole is at infinity; far away will do.
        difference = 1.0 + feedback
        feedback = feedback / np.where(difference == 0, np.finfo(float).eps, difference)
    loops: Complexes = np.repeat(chain[None], gains.size, axis=0)
    reached = slice(1) if without else slice(None)
    loops[:, reached] -= feedback[:, None, None] * output
    return np.asarray(np.linalg.eigvals(loops), dtype=complex)
