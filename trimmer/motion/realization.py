"""A linear system in state space."""

from __future__ import annotations

from typing import TYPE_CHECKING

import control
import numpy as np
import scipy.signal

from trimmer.motion.errors import UnsupportedMotionError

if TYPE_CHECKING:
    from numpy.typing import NDArray


def realized(system: control.LTI) -> control.StateSpace:
    """Return a state-space model with one input and one output, which is the system itself if it is one.

    Raises:
        UnsupportedMotionError: if the system is none of python-control's transfer functions and state-space
            models in continuous time, has several inputs or outputs, or is improper.
        ValueError: if a coefficient is not finite.
    """
    if not isinstance(system, control.StateSpace | control.TransferFunction):
        raise UnsupportedMotionError(
            f"give a control.StateSpace or control.TransferFunction, not {type(system).__name__}"
        )
    if system.isdtime(strict=True):
        raise UnsupportedMotionError("the system must be continuous in time, not sampled")
    if (system.ninputs, system.noutputs) != (1, 1):
        raise UnsupportedMotionError(
            f"the system must have one input and one output, not {system.ninputs} and {system.noutputs}"
        )
    if isinstance(system, control.StateSpace):
        _require_finite(A=system.A, B=system.B, C=system.C, D=system.D)
        return system
    numerator, denominator = system.num[0][0], system.den[0][0]
    _require_finite(numerator=numerator, denominator=denominator)
    if len(numerator) > len(denominator):
        raise UnsupportedMotionError("the transfer function has more zeros than poles")
    return control.ss(*scipy.signal.tf2ss(numerator, denominator))


def _require_finite(**parts: NDArray[np.float64]) -> None:
    for name, values in parts.items():
        if not np.isfinite(values).all():
            raise ValueError(f"{name} of the system must be finite, not {values.tolist()!r}")
