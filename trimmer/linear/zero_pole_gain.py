"""A system as gain, zeros and poles, and its gain and phase as sums over them.

In this form a narrow resonance is as exact as a wide one: the distance from j omega to a pole is computed
directly, not as a small difference of large powers of omega.
"""

from dataclasses import dataclass
from typing import Self

import control
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg.lapack import dgebal, dgeev

from trimmer.arrays import Complexes, Reals
from trimmer.linear.frequency_response import UnsupportedSystemError, require_siso
from trimmer.showing.shown import Shown, counted

_ROUNDING = 64 * np.finfo(float).eps
"""Relative size below which a computed quantity is taken for a rounded zero."""


@dataclass(frozen=True, repr=False)
class ZeroPoleGain(Shown):
    """G(s) = gain (s - z1)(s - z2).../((s - p1)(s - p2)...).

    A root that the imaginary axis holds as well, to rounding of the coefficients (of a state-space system: of
    the largest root), has the real part 0: a root on the axis is there exactly.

    Attributes:
        gain: Factor, in the unit of output over input times (rad/s)^relative_degree.
        zeros: Zeros, rad/s, by rising magnitude.
        poles: Poles, rad/s, by rising magnitude.
    """

    gain: float
    zeros: tuple[complex, ...]
    poles: tuple[complex, ...]

    @classmethod
    def of(cls, system: control.lti.LTI) -> Self:
        """Factor a system.

        python-control gives the zeros of a state-space system with spurious ones near infinity, so those are
        computed here.

        Raises:
            UnsupportedSystemError: see ``require_siso``; or if the system is identically zero, or one of its
                coefficients is infinite or NaN.
        """
        require_siso(system)
        _require_finite(system)
        if isinstance(system, control.TransferFunction):
            numerator, denominator = (np.trim_zeros(side[0][0], "f") for side in (system.num, system.den))
            if numerator.size == 0:
                raise _zero_system()
            gain = numerator[0] / denominator[0]
            return cls(float(gain), _ordered(roots_of(numerator)), _ordered(roots_of(denominator)))
        gain, zeros = _gain_and_zeros(system)
        return cls(gain, *(_ordered(_without_rounding(roots)) for roots in (zeros, _eigenvalues(system.A))))

    def _told(self) -> str:
        roots = (counted(len(self.zeros), "zero"), counted(len(self.poles), "pole"))
        return f"gain {self.gain:.6g}, {' and '.join(roots)}"

    @property
    def relative_degree(self) -> int:
        """Number of poles less number of zeros."""
        return len(self.poles) - len(self.zeros)

    @property
    def static_gain(self) -> float:
        """Limit of G(s) for s to 0, in the unit of output over input.

        It is infinite, without a sign, if poles at 0 outnumber zeros there.
        """
        at_origin = self.roots == 0
        excess = self.exponents[at_origin].sum()
        if excess != 0:
            return 0.0 if excess > 0 else np.inf
        factors = (-self.roots[~at_origin]) ** self.exponents[~at_origin]
        return float(self.gain * np.prod(factors).real)

    @property
    def roots(self) -> Complexes:
        """All zeros, then all poles, rad/s, shape (number of roots,)."""
        return np.array(self.zeros + self.poles, dtype=complex)

    @property
    def exponents(self) -> Reals:
        """Exponent of each of ``roots`` in G, of the same shape: +1 for a zero, -1 for a pole."""
        return np.repeat([1.0, -1.0], [len(self.zeros), len(self.poles)])

    def log_gain(self, omega: ArrayLike) -> Reals:
        """Natural logarithm of |G(j omega)| at omega (rad/s), in its shape.

        It is -inf at a zero on the axis and inf at a pole on it.
        """
        with np.errstate(divide="ignore"):
            distances = np.log(np.abs(1j * np.asarray(omega)[..., None] - self.roots))
        return np.asarray(np.log(abs(self.gain)) + distances @ self.exponents)

    def phase(self, omega: ArrayLike) -> Reals:
        """Phase of G(j omega), rad, at omega (rad/s), in its shape.

        It is continuous in omega but for jumps of pi at roots on the axis.
        """
        rise = np.asarray(omega)[..., None] - self.roots.imag
        run = -self.roots.real
        with np.errstate(divide="ignore", invalid="ignore"):
            on_axis = np.sign(rise) * np.pi / 2
            angles = np.where(run == 0, on_axis, np.arctan(rise / run) + np.where(run < 0, np.pi, 0.0))
        return np.asarray(angles @ self.exponents + (np.pi if self.gain < 0 else 0.0))

    def log_gain_slope_terms(self, omega: float) -> Reals:
        """Share of each of ``roots`` in d ln|G| / d omega, s; 0 for a root that lies at j omega itself."""
        return -self._slope_terms(omega).imag

    def phase_slope_terms(self, omega: float) -> Reals:
        """Share of each of ``roots`` in d(phase) / d omega, s; 0 for a root on the axis."""
        return self._slope_terms(omega).real

    def _slope_terms(self, omega: float) -> Complexes:
        distance = 1j * omega - self.roots
        safe = np.where(distance == 0, np.inf, distance)
        return np.asarray(self.exponents / safe, dtype=complex)


_NEAR_AXIS = 1e-6
"""Real part over modulus up to which a root may be one on the axis; a double one has half of the digits."""


def roots_of(polynomial: ArrayLike) -> Complexes:
    """Find the roots of a real polynomial, highest power first, whose first coefficient is not 0.

    They are those of the companion matrix, with s in units of their mean size: unscaled, the matrix of many
    slow roots loses them. A root moves onto the imaginary axis if that holds one too, to rounding of the
    coefficients. What is rounding follows from the coefficients at that very place: beside 1e9 rad/s a root
    at -1e-9 rad/s is one.
    """
    coefficients = np.trim_zeros(np.asarray(polynomial, dtype=float), "b")
    order, at_origin = coefficients.size - 1, np.size(polynomial) - coefficients.size
    octave = 0
    if order:
        first, last = np.frexp(coefficients[[0, -1]])[1]
        octave = round(int(last - first) / order)
    mantissas, exponents = np.frexp(coefficients)
    exponents = exponents - exponents[0] - octave * np.arange(order + 1)
    scaled = np.ldexp(mantissas, exponents)
    roots = _on_axis_if_it_holds(np.roots(scaled).astype(complex), scaled)
    return np.concatenate([np.ldexp(1.0, octave) * roots, np.zeros(at_origin)])


def _on_axis_if_it_holds(roots: Complexes, coefficients: Reals) -> Complexes:
    """Set real parts to 0 where that leaves a root of the polynomial, to rounding of its coefficients."""
    near = np.flatnonzero((np.abs(roots.real) <= _NEAR_AXIS * np.abs(roots)) & (roots.real != 0))
    place = roots.imag[near]
    with np.errstate(all="ignore"):
        value = np.abs(np.polyval(coefficients, 1j * place))
        size = np.polyval(np.abs(coefficients), np.abs(place))
        roots.real[near[value <= 4.0 * roots.size * np.finfo(float).eps * size]] = 0.0
    return roots


def _without_rounding(roots: NDArray[np.inexact]) -> Complexes:
    """Set real parts to 0 that are rounding beside the largest root."""
    cleaned = roots.astype(complex)
    cleaned.real[np.abs(cleaned.real) <= _ROUNDING * np.abs(cleaned).max(initial=0.0)] = 0.0
    return cleaned


def _ordered(roots: Complexes) -> tuple[complex, ...]:
    """Put roots in order of magnitude, then of imaginary part."""
    return tuple(roots[np.lexsort((roots.imag, np.abs(roots)))].tolist())


def _gain_and_zeros(system: control.StateSpace) -> tuple[float, NDArray[np.inexact]]:
    """Gain and zeros of a state-space system through its zero dynamics.

    The first Markov parameter D, C B, C A B, ... that is not zero is the gain; its place is the relative
    degree r. The zeros are the poles of what can move while the output and its first r - 1 derivatives stay
    zero (Isidori, Nonlinear Control Systems, section 4.3, for the linear case). Each of these takes one
    state away: the rest is turned so that the output is one state, and that state's rate is the next output.
    """
    A, column, row = _balanced(system)
    given, held = row, 0
    markov = bound = direct = float(system.D[0, 0])
    while abs(markov) <= _ROUNDING * bound:
        if held == system.nstates:
            raise _zero_system()
        held += 1
        markov, bound = float(row @ column), float(np.abs(row) @ np.abs(column))
        row = row @ A
    free, output = A, given
    for _ in range(held):
        along, across = _along_and_across(output)
        output, direct = along @ free @ across, float(along @ column)
        free, column = across.T @ free @ across, across.T @ column
    return markov, _eigenvalues(free - column[:, None] * output / direct)


def _along_and_across(direction: Reals) -> tuple[Reals, Reals]:
    """Return the unit vector along a direction or against it, and an orthonormal basis across, as columns."""
    normal = direction / np.linalg.norm(direction)
    normal[0] += 1.0 if normal[0] >= 0 else -1.0
    reflected = np.eye(direction.size)
    reflected -= normal[:, None] * (normal / abs(normal[0]))
    return reflected[:, 0], reflected[:, 1:]


def _eigenvalues(matrix: Reals) -> Complexes:
    """Eigenvalues from LAPACK itself: NumPy's checks take longer than the work on a small matrix."""
    if matrix.size == 0:
        return np.empty(0, dtype=complex)
    real, imaginary, _, _, failed = dgeev(matrix, compute_vl=0, compute_vr=0)
    if failed:
        raise np.linalg.LinAlgError("the eigenvalues of the system do not converge")
    return np.asarray(real + 1j * imaginary)


def _balanced(system: control.StateSpace) -> tuple[Reals, Reals, Reals]:
    """Scale states, input and output so that A, B and C are of like size; return these three.

    Input and output are scaled against each other by powers of two, which leaves G as it is.
    """
    order = system.nstates
    if order == 0:
        return system.A, system.B[:, 0], system.C[0]
    whole = np.empty((order + 1, order + 1))
    whole[:order, :order], whole[:order, order:] = system.A, system.B
    whole[order:, :order], whole[order:, order:] = system.C, system.D
    whole = dgebal(whole, scale=1, permute=0)[0]
    return whole[:order, :order], whole[:order, order], whole[order, :order]


def _require_finite(system: control.lti.LTI) -> None:
    if isinstance(system, control.TransferFunction):
        parts = {"numerator": system.num[0][0], "denominator": system.den[0][0]}
    else:
        parts = {"A": system.A, "B": system.B, "C": system.C, "D": system.D}
    for name, coefficients in parts.items():
        if not np.isfinite(coefficients).all():
            raise UnsupportedSystemError(f"{name} of the system holds a number that is infinite or NaN")


def _zero_system() -> UnsupportedSystemError:
    return UnsupportedSystemError("the system is identically zero: its input does not reach its output")
