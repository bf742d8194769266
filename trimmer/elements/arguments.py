"""Checks of the arguments of an element: fields, amplitudes, frequencies, harmonics."""

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_number, real_values, shown
from trimmer.arrays import Reals
from trimmer.errors import WrongTypeError


def require_not_negative(field: str, value: float, unit: str) -> None:
    """Check that a field of an element is zero, positive or infinite, and not NaN."""
    if not real_number(field, value, unit) >= 0:
        raise ValueError(f"{field} must be zero, positive or infinite ({unit}), not {value!r}")


def positive_amplitudes(amplitude: ArrayLike) -> Reals:
    """Return amplitudes as an array of the same shape; infinity and NaN pass."""
    return _positive("amplitude", amplitude, "half of peak to peak, in the unit of the input")


def positive_omegas(omega: ArrayLike) -> Reals:
    """Return angular frequencies, rad/s, as an array of the same shape; NaN passes."""
    omegas = _positive("omega", omega, "rad/s")
    if np.count_nonzero(np.isinf(omegas)):
        raise ValueError("omega must be finite (rad/s), not inf")
    return omegas


def _positive(name: str, values: ArrayLike, unit: str) -> Reals:
    array = np.asarray(values) if isinstance(values, np.ndarray | float) else real_values(name, values)
    if array.dtype.kind not in "fiu":
        raise WrongTypeError(
            f"{name} must be a real number or an array of such ({unit}), not {shown(values)}"
        )
    array = array.astype(float, copy=False)
    wrong = array <= 0
    if np.count_nonzero(wrong):
        raise ValueError(f"{name} must be positive ({unit}), not {float(array[wrong][0])!r}")
    return array
