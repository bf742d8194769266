"""A linear system as engineers have it, in state space: of python-control or of SciPy."""

from __future__ import annotations

from typing import TYPE_CHECKING

import control
import numpy as np
import scipy.signal

from trimmer.arguments import shown
from trimmer.errors import UnsupportedMotionError

if TYPE_CHECKING:
    from trimmer.arrays import Reals


def taken_system(system: object) -> control.LTI:
    """Return a system of python-control as it is, and one of SciPy in state space.

    Raises:
        UnsupportedMotionError: if it is none of a transfer function and a state-space model.
    """
    if isinstance(system, scipy.signal.lti):
        found = system.to_ss()
        return control.ss(found.A, found.B, found.C, found.D)
    if not isinstance(system, control.StateSpace | control.TransferFunction):
        raise UnsupportedMotionError(
            f"system: give a control.StateSpace or control.TransferFunction, not {type(system).__name__} "
            f"({shown(system)})"
        )
    return system


def in_state_space(system: control.LTI) -> control.StateSpace:
    """Return a system in state space, with its names, which is the system itself if it is one.

    Raises:
        UnsupportedMotionError: if it is sampled or improper, or a transfer function of several inputs or
            outputs that python-control cannot realize.
        ValueError: if a coefficient is not finite.
    """
    if system.isdtime(strict=True):
        raise UnsupportedMotionError("the system must be continuous in time, not sampled")
    if isinstance(system, control.StateSpace):
        _require_finite(A=system.A, B=system.B, C=system.C, D=system.D)
        return system
    for numerator, denominator in zip(np.ravel(system.num_array), np.ravel(system.den_array), strict=True):
        _require_finite(numerator=numerator, denominator=denominator)
        if len(numerator) > len(denominator):
            raise UnsupportedMotionError("the transfer function has more zeros than poles")
    names = {"inputs": system.input_labels, "outputs": system.output_labels}
    if (system.ninputs, system.noutputs) == (1, 1):
        matrices = scipy.signal.tf2ss(system.num_array[0, 0], system.den_array[0, 0])
        return control.ss(*matrices, **names)
    try:
        return control.ss(system, **names)
    except (control.ControlMIMONotImplemented, ImportError) as error:
        raise UnsupportedMotionError(
            f"the transfer function of {system.ninputs} inputs and {system.noutputs} outputs has no "
            f"realization here ({error}); give a control.StateSpace"
        ) from error


def realized(system: control.LTI) -> control.StateSpace:
    """Return a state-space model with one input and one output; see ``in_state_space``.

    Raises:
        UnsupportedMotionError: if it has several, too.
        ValueError: if a coefficient is not finite.
    """
    if not system.isdtime(strict=True) and (system.ninputs, system.noutputs) != (1, 1):
        raise UnsupportedMotionError(
            f"the system must have one input and one output, not {system.ninputs} and {system.noutputs}"
        )
    return in_state_space(system)


def _require_finite(**parts: Reals) -> None:
    for name, values in parts.items():
        if not np.isfinite(values).all():
            raise ValueError(f"{name} of the system must be finite, not {values.tolist()!r}")
