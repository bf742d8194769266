"""Response of a linear system in time, sampled and in the sinusoidal steady state."""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from typing import TYPE_CHECKING

import control
import numpy as np

from trimmer.linear.frequency_response import UnsupportedSystemError, frequency_response, require_siso

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Reals


@dataclass(frozen=True, eq=False)
class TimeResponse:
    """A sampled response.

    Attributes:
        times: Instants, s, shape (n,).
        output: Output at them, shape (n,), or (number of outputs, n) if the system has several; in its unit.
        states: States at them, shape (number of states, n), in their units.
    """

    times: Reals
    output: Reals
    states: Reals


@dataclass(frozen=True)
class SteadyState:
    """The output amplitude * sin(omega t + phase) that is left in the end when the input is a sine.

    Attributes:
        omega: Angular frequency, rad/s.
        amplitude: Amplitude of the output, in the unit of the output.
        phase: Phase of the output relative to the input sin(omega t), rad, in (-pi, pi].
    """

    omega: float
    amplitude: float
    phase: float

    def at(self, times: ArrayLike) -> Reals:
        """Evaluate the output at instants (s), in the shape of ``times``."""
        return np.asarray(self.amplitude * np.sin(self.omega * np.asarray(times) + self.phase))


def time_response(
    system: control.StateSpace,
    samples: ArrayLike,
    times: ArrayLike,
    initial_state: ArrayLike | float = 0.0,
) -> TimeResponse:
    """Compute the response to an input that is linear between its samples; for such an input it is exact.

    Args:
        system: A continuous-time system. A transfer function is refused: its states are not defined, and
            converting it loses digits; build the state space instead (``pin_model``), or use ``control.ss``.
        samples: Input at the instants in its unit, shape (n,), or (number of inputs, n) if there are several.
        times: Instants, s, shape (n,), at equal distances.
        initial_state: State at the first instant, shape (number of states,), or one number for every state.

    Raises:
        UnsupportedSystemError: if the system is not a continuous-time StateSpace.
        ValueError: if the shapes do not fit together or the instants are not at equal distances.
    """
    if not isinstance(system, control.StateSpace) or not system.isctime():
        raise UnsupportedSystemError("a time response needs a continuous-time control.StateSpace")
    response = control.forced_response(
        system,
        timepts=np.asarray(times),
        inputs=np.asarray(samples),
        initial_state=initial_state,
        squeeze=False,
    )
    outputs = np.asarray(response.outputs)
    output = outputs[0] if system.noutputs == 1 else outputs
    return TimeResponse(np.asarray(response.time), output, np.asarray(response.states))


def steady_state(system: control.lti.LTI, omega: float, amplitude: float = 1.0) -> SteadyState:
    """Compute the steady response to amplitude * sin(omega t), exactly, from G(j omega).

    Args:
        system: A stable system with one input and one output.
        omega: Angular frequency of the input, rad/s, > 0.
        amplitude: Amplitude of the input, in its unit.

    Raises:
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``; or if the system is
            not asymptotically stable, so that transients remain.
    """
    require_siso(system)
    slowest = max((pole.real for pole in system.poles()), default=-1.0)
    if slowest >= 0:
        raise UnsupportedSystemError(
            f"the system has a pole with real part {slowest:g} 1/s: it does not settle into a steady state"
        )
    gain = complex(frequency_response(system, omega))
    return SteadyState(omega, amplitude * abs(gain), cmath.phase(gain))
