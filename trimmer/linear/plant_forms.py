"""Linear systems in the forms in which people have them, as systems of python-control."""

from typing import Any

import control
import numpy as np
import scipy.signal
from numpy.typing import ArrayLike

from trimmer.arguments import shown
from trimmer.arrays import Complexes
from trimmer.linear.frequency_response import UnsupportedSystemError

FORMS = "(num, den), (z, p, k) and (A, B, C, D)"
PAIRED = 1e-9  # Distance of two conjugate roots, relative to their size, up to which they are a pair


def is_plain_form(system: object) -> bool:
    """Return whether a system is one of SciPy, or a tuple of arrays, neither of which has names."""
    return isinstance(system, scipy.signal.lti | tuple)


def adopted_system(system: object) -> object:
    """Return a system of SciPy, or a tuple of its arrays, as one of python-control; others as they are.

    Tuples are ``(num, den)`` of descending powers, ``(z, p, k)`` with roots in rad/s, and ``(A, B, C,
    D)``. Zeros and poles become a chain of sections in state space, whose poles are those that were
    given, to the last digit; multiplied out, close ones would lose half of them.
    """
    if isinstance(system, scipy.signal.dlti):
        raise UnsupportedSystemError(
            f"a sampled system (dt = {system.dt}) is not accepted: the system must be continuous in time"
        )
    try:
        return _of_scipy(system) if isinstance(system, scipy.signal.lti) else _of_arrays(system)
    except UnsupportedSystemError:
        raise
    except (TypeError, ValueError) as error:
        raise UnsupportedSystemError(
            f"system: {shown(system)} makes no system ({error}); tuples are {FORMS}"
        ) from error


def _of_scipy(system: scipy.signal.lti) -> control.LTI:
    if isinstance(system, scipy.signal.StateSpace):
        return control.ss(system.A, system.B, system.C, system.D)
    if isinstance(system, scipy.signal.ZerosPolesGain):
        return chain_of_sections(system.zeros, system.poles, system.gain)
    return control.tf(system.num, system.den)


def _of_arrays(system: Any) -> object:
    """Return a tuple of arrays as a system, and what is none as it is."""
    if not isinstance(system, tuple):
        return system
    match len(system):
        case 2:
            return control.tf(*system)
        case 3:
            return chain_of_sections(*system)
        case 4:
            return control.ss(*system)
    raise UnsupportedSystemError(f"system: a tuple of {len(system)} is no system; tuples are {FORMS}")


def chain_of_sections(zeros: ArrayLike, poles: ArrayLike, gain: float) -> control.StateSpace:
    """Return gain prod(s - zero)/prod(s - pole), rad/s, as sections of one or two poles in a row."""
    z, p = (np.atleast_1d(np.asarray(each, dtype=complex)).ravel() for each in (zeros, poles))
    if not (np.isfinite(z).all() and np.isfinite(p).all() and np.isfinite(gain)):
        raise UnsupportedSystemError("zeros, poles and gain of the system must be finite")
    if z.size > p.size:
        raise UnsupportedSystemError("the system has more zeros than poles")
    numerators, blocks = _in_pairs("zeros", z), _in_pairs("poles", p)
    system = control.ss([], [], [], [[float(gain)]])
    for block in blocks:
        count = min(len(block), sum(map(len, numerators)))
        system = _section(block, _taken(numerators, count)) * system
    return system


def _in_pairs(name: str, roots: Complexes) -> list[Complexes]:
    """Return complex roots with their conjugates, then real ones two by two, the last alone if it is one."""
    above, below, real = roots[roots.imag > 0], roots[roots.imag < 0], roots[roots.imag == 0]
    left = below.conj().tolist()
    for root in above:
        partner = min(left, key=lambda other: abs(other - root), default=None)
        if partner is None or abs(partner - root) > PAIRED * abs(root):
            raise UnsupportedSystemError(
                f"the {name} of the system must come in conjugate pairs; {root:.6g} has none"
            )
        left.remove(partner)
    if left:
        raise UnsupportedSystemError(
            f"the {name} of the system must come in conjugate pairs; {left[0].conjugate():.6g} has none"
        )
    pairs = [np.array([root, root.conjugate()]) for root in above]
    return pairs + [real[first : first + 2] for first in range(0, real.size, 2)]


def _taken(numerators: list[Complexes], count: int) -> Complexes:
    """Take a numerator of at most so many roots out of a list."""
    for place, roots in enumerate(numerators):
        if len(roots) <= count:
            return numerators.pop(place)
    return np.empty(0, dtype=complex)


def _section(poles: Complexes, zeros: Complexes) -> control.StateSpace:
    """Return prod(s - zero)/prod(s - pole) of one or two poles, real or a pair, and as many zeros at most."""
    numerator = np.poly(zeros) if zeros.size else np.ones(1)
    b = np.concatenate([np.zeros(poles.size + 1 - numerator.size), numerator])
    first, last, turning = poles[0].real, poles[-1].real, poles[0].imag
    if poles.size == 1:
        return control.ss([[first]], [[1.0]], [[b[1] + b[0] * first]], [[b[0]]])
    # Of x1' = first x1 - turning x2 + u and x2' = passed x1 + last x2 the determinant is that of the poles.
    passed = turning or 1.0
    along = b[1] + b[0] * (first + last)
    across = (b[2] - b[0] * (first * last + turning**2) + along * last) / passed
    return control.ss([[first, -turning], [passed, last]], [[1.0], [0.0]], [[along, across]], [[b[0]]])
