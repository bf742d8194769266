"""Encirclements of a point by the Nyquist locus."""

import cmath

import control

from trimmer.arguments import finite_number
from trimmer.errors import TrimmerError
from trimmer.linear.frequency_response import UnsupportedSystemError
from trimmer.linear.zero_pole_gain import ZeroPoleGain

_SAME = 1e-9  # Relative distance within which a zero and a pole are the same, both rounded


class PointOnLocusError(TrimmerError, ValueError):
    """The locus passes through the point, so that encirclements of it are not defined."""


def encirclements(system: control.lti.LTI, point: float = -1.0) -> int:
    """Count the clockwise encirclements of a point of the real axis by G(j omega), omega from -inf to inf.

    By the principle of the argument this is N = Z - P (equation 2.23 of the thesis), with Z the zeros of
    G(s) - point and P the poles of G(s) in the right half plane. Counting roots needs no contour; one that
    is sampled, as in ``control.nyquist_response``, goes astray at poles nearer to the axis than its
    indentation. Poles on the imaginary axis are passed on the right.

    Args:
        system: A proper system with one input and one output.
        point: The point, a real number in the unit of output over input.

    Returns:
        Number of clockwise encirclements; negative if they are counter-clockwise.

    Raises:
        PointOnLocusError: if the locus passes through the point, be it at infinite frequency.
        ValueError: if the point is not finite.
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``; or if the system is
            not proper.
    """
    finite_number("point", point)
    open_loop = ZeroPoleGain.of(system)
    if open_loop.relative_degree < 0:
        raise UnsupportedSystemError("the system has more zeros than poles: its Nyquist locus does not close")
    shifted = ZeroPoleGain.of(system - point)
    if shifted.relative_degree > 0 or _meet_on_axis(shifted):
        raise PointOnLocusError(f"the point {point:g} lies on the Nyquist locus")
    return _in_right_half_plane(shifted.zeros) - _in_right_half_plane(open_loop.poles)


def _in_right_half_plane(roots: tuple[complex, ...]) -> int:
    return sum(root.real > 0 for root in roots)


def _meet_on_axis(shifted: ZeroPoleGain) -> bool:
    """Whether G(j omega) equals the point somewhere; an undamped mode that G does not see is no meeting."""
    hidden = [pole for pole in shifted.poles if pole.real == 0]
    return any(
        zero.real == 0 and not any(cmath.isclose(zero, pole, rel_tol=_SAME) for pole in hidden)
        for zero in shifted.zeros
    )
