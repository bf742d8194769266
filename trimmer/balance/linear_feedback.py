"""1/G + constant + damping s: the inverse response of a system with a linear feedback round it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.frequency_domain import UnsupportedSystemError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.inverse_response import InverseResponse
    from trimmer.balance.linear_part import LinearGain

    Complexes = NDArray[np.complex128]

_ROUNDING = 64 * np.finfo(float).eps
"""Relative size below which a computed quantity is taken for a rounded zero."""

_POLISHING = 3
"""Steps, each of which squares the error of a root."""


def with_feedback(response: InverseResponse, feedback: LinearGain) -> InverseResponse:
    """Add a linear gain to 1/G.

    The sum has the zeros of G as its poles; its zeros, the poles of the loop, are those of a polynomial.

    Raises:
        UnsupportedSystemError: if the highest powers of s cancel, so that the loop has no bounded response.
    """
    zeros, poles = np.poly(response.zeros), np.poly(response.poles)
    gains = np.array([feedback.damping * response.reference, feedback.constant])
    added = np.polymul(np.trim_zeros(gains, "f"), zeros)
    total = np.polyadd(response.gain * poles, added)
    sizes = np.polyadd(abs(response.gain) * np.abs(poles), np.abs(added))
    if abs(total[0]) <= _ROUNDING * sizes[0]:
        raise UnsupportedSystemError(
            "the linear part of the element cancels the highest derivative in the system: change either"
        )
    rooted = _polished(np.roots(total).astype(complex), total[0], response, feedback)
    return replace(response, gain=total[0], poles=_cleaned(rooted))


def _polished(
    roots: Complexes, leading: complex, response: InverseResponse, feedback: LinearGain
) -> Complexes:
    """Improve roots by Weierstrass's method, with the polynomial in factors, which lose no digits."""
    for _ in range(_POLISHING):
        apart = roots[:, None] - roots
        np.fill_diagonal(apart, 1.0)
        added = feedback.constant + feedback.damping * response.reference * roots
        value = response.gain * (roots[:, None] - response.poles).prod(axis=1)
        value = value + added * (roots[:, None] - response.zeros).prod(axis=1)
        with np.errstate(all="ignore"):
            step = value / (leading * apart.prod(axis=1))
        roots = np.where(np.isfinite(step), roots - step, roots)
    return roots


def _cleaned(roots: Complexes) -> Complexes:
    """Put roots in order of magnitude, and on the axis if they are there to rounding."""
    roots = roots[np.argsort(np.abs(roots))]
    negligible = _ROUNDING * np.abs(roots).max(initial=0.0)
    return np.asarray(np.where(np.abs(roots.real) <= negligible, 1j * roots.imag, roots))
