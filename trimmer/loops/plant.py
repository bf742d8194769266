"""The linear system of a loop: taken as people have it, and realized in state space for its motion."""

import control
import numpy as np
import scipy.signal

from trimmer.arguments import shown
from trimmer.arrays import Reals
from trimmer.errors import UnsupportedMotionError
from trimmer.linear.plant_forms import FORMS, adopted_system


def taken_system(system: object) -> control.LTI:
    """Return a system as one of python-control, whatever form it has; see ``adopted_system``."""
    found = adopted_system(system)
    if isinstance(found, control.FrequencyResponseData):
        raise UnsupportedMotionError(
            "system: give a control.StateSpace or control.TransferFunction, not FrequencyResponseData: how a "
            "plant moves does not follow from its response at some frequencies; "
            "harmonic_balance(data, element) predicts limit cycles from them"
        )
    if not isinstance(found, control.StateSpace | control.TransferFunction):
        raise UnsupportedMotionError(
            "system: give a control.StateSpace or control.TransferFunction, a system of SciPy, or one of the "
            f"tuples {FORMS}, not {type(system).__name__} ({shown(system)})"
        )
    return found


def in_state_space(system: control.LTI) -> control.StateSpace:
    """Return a continuous proper system with finite coefficients in state space, with its names."""
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
    """Return a state-space model with one input and one output; see ``in_state_space``."""
    if not system.isdtime(strict=True) and (system.ninputs, system.noutputs) != (1, 1):
        raise UnsupportedMotionError(
            f"the system must have one input and one output, not {system.ninputs} and {system.noutputs}"
        )
    return in_state_space(system)


def _require_finite(**parts: Reals) -> None:
    for name, values in parts.items():
        if not np.isfinite(values).all():
            raise ValueError(f"{name} of the system must be finite, not {values.tolist()!r}")
