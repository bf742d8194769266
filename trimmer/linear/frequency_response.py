"""Frequency response, and which systems the frequency-domain functions accept.

They all take a continuous-time system of python-control with one input and one output, rational and without
delay: a ``control.StateSpace`` or a ``control.TransferFunction``. It need not be a trimmer, nor stable.
"""

import control
import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_values, shown
from trimmer.arrays import Complexes
from trimmer.errors import TrimmerError


class UnsupportedSystemError(TrimmerError, ValueError):
    """A system that a function cannot treat; the message says what it is and what is accepted."""


def require_siso(system: control.lti.LTI) -> None:
    """Check that a system is a rational, continuous-time one with one input and one output."""
    if not isinstance(system, control.StateSpace | control.TransferFunction):
        raise UnsupportedSystemError(
            f"as the system (G) {type(system).__name__} is not accepted: give a control.StateSpace or "
            f"control.TransferFunction, not {shown(system)}"
        )
    if not system.isctime():
        raise UnsupportedSystemError(f"a discrete-time system (dt = {system.dt}) is not accepted")
    if not system.issiso():
        raise UnsupportedSystemError(
            f"a system of {system.ninputs} inputs and {system.noutputs} outputs is not accepted: choose one "
            "of each, as in system[0, 0]"
        )


def response_at(system: control.lti.LTI, omega: ArrayLike) -> Complexes:
    """Evaluate G(j omega) (equations 2.15 and 2.16 of the thesis).

    Args:
        system: A system with one input and one output.
        omega: Angular frequencies, rad/s, of any shape.

    Returns:
        Complex array of the shape of ``omega``, in the unit of output over input.

    Raises:
        UnsupportedSystemError: see ``require_siso``.
    """
    require_siso(system)
    frequencies = real_values("omega", omega)
    response = system(1j * frequencies.ravel(), squeeze=True)
    return np.asarray(response, dtype=complex).reshape(frequencies.shape)
