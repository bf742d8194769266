"""A linear system in state space."""

from __future__ import annotations

import control
import scipy.signal

from trimmer.motion.errors import UnsupportedMotionError


def realized(system: control.LTI) -> control.StateSpace:
    """Return a state-space model with one input and one output, which is the system itself if it is one.

    Raises:
        UnsupportedMotionError: if the system is none of python-control's transfer functions and state-space
            models in continuous time, has several inputs or outputs, or is improper.
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
        return system
    numerator, denominator = system.num[0][0], system.den[0][0]
    if len(numerator) > len(denominator):
        raise UnsupportedMotionError("the transfer function has more zeros than poles")
    return control.ss(*scipy.signal.tf2ss(numerator, denominator))
