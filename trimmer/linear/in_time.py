"""Response of a linear system in time, sampled and in the sinusoidal steady state."""

import cmath
from dataclasses import dataclass

import control
import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import positive_number, real_array, real_number, real_values
from trimmer.arrays import Reals
from trimmer.linear.frequency_response import UnsupportedSystemError, require_siso, response_at
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import ShownFields, Tabular
from trimmer.showing.table import Column, Table, arrays

SPACING_TOLERANCE = 1e-6
"""How far a distance between instants may be off, relative to the first; time stamps are rounded."""


@dataclass(frozen=True, eq=False, repr=False)
class TimeResponse(Tabular, Drawn):
    """A sampled response, with the names and shapes of python-control's ``TimeResponseData``.

    ``plot`` draws inputs and outputs over time, in their units.

    Attributes:
        time: Instants, s, shape (n,).
        outputs: Outputs at them in their units, shape (n,) for a system with one input and one output, else
            (number of outputs, n).
        states: States at them, shape (number of states, n), in their units.
        inputs: Inputs at them in their units, shape (n,) for a system with one input and one output, else
            (number of inputs, n).
    """

    time: Reals
    outputs: Reals
    states: Reals
    inputs: Reals

    @property
    def named(self) -> dict[str, Reals]:
        """Inputs and outputs by their names, each of shape (n,): numbered from 1 where there are several."""
        return {**_numbered("input", self.inputs), **_numbered("output", self.outputs)}

    def _told(self) -> str:
        return f"{self.time.size} samples from {self.time[0]:.6g} to {self.time[-1]:.6g} s"

    def _table(self) -> Table:
        signals = {**self.named, **_numbered("state", np.atleast_2d(self.states))}
        columns = (Column(name, "", values.__getitem__) for name, values in signals.items())
        return Table("Samples", range(self.time.size), (*arrays(time=("s", self.time)), *columns))


def _numbered(name: str, values: Reals) -> dict[str, Reals]:
    if values.ndim == 1:
        return {name: values}
    return {f"{name} {number}": each for number, each in enumerate(values, start=1)}


@dataclass(frozen=True)
class SteadyState(ShownFields):
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
        return np.asarray(self.amplitude * np.sin(self.omega * real_values("times", times) + self.phase))


def time_response(
    system: control.StateSpace, times: ArrayLike, inputs: ArrayLike, initial_state: ArrayLike | float = 0.0
) -> TimeResponse:
    """Compute the response to an input that is linear between its samples; for such an input it is exact.

    The order of the arguments is that of ``control.forced_response``.

    Args:
        system: A continuous-time system. A transfer function is refused: its states are not defined, and
            converting it loses digits; build the state space instead (``pin_model``), or use ``control.ss``.
        times: Instants, s, shape (n,), n >= 2, rising at equal distances.
        inputs: Input at the instants in its unit, shape (n,), or (number of inputs, n) if there are several.
        initial_state: State at the first instant, shape (number of states,), or one number for every state.

    Raises:
        UnsupportedSystemError: if the system is not a continuous-time StateSpace.
        ValueError: if the instants do not rise at equal distances, the shapes do not fit together, or a
            number is not real and finite.
    """
    if not isinstance(system, control.StateSpace) or not system.isctime():
        raise UnsupportedSystemError(
            f"system: a time response needs a continuous-time control.StateSpace, not {system!r}"
        )
    instants = _checked_times(times)
    samples = _checked_inputs(inputs, instants.size, system.ninputs)
    response = control.forced_response(
        system,
        timepts=instants,
        inputs=samples,
        initial_state=_checked_state(initial_state, system.nstates),
        squeeze=False,
    )
    outputs, given = np.asarray(response.outputs), samples.reshape(system.ninputs, -1)
    if system.issiso():
        outputs, given = outputs[0], given[0]
    return TimeResponse(np.asarray(response.time), outputs, np.asarray(response.states), given)


def _checked_times(times: ArrayLike) -> Reals:
    instants = real_array("times", times)
    if instants.ndim != 1 or instants.size < 2:
        raise ValueError(
            f"times must be two or more instants in one dimension, not of shape {instants.shape}"
        )
    distances = np.diff(instants)
    if (distances <= 0).any():
        place = int(np.argmax(distances <= 0))
        raise ValueError(
            f"times must rise, but {float(instants[place])!r} s is followed by "
            f"{float(instants[place + 1])!r} s; the instants come before the inputs"
        )
    uneven = abs(distances - distances[0]) > SPACING_TOLERANCE * distances[0]
    if uneven.any():
        place = int(np.argmax(uneven))
        raise ValueError(
            f"times must be at equal distances: they begin {float(distances[0])!r} s apart, but after "
            f"{float(instants[place])!r} s the distance is {float(distances[place])!r} s; resample the input"
        )
    return instants


def _checked_inputs(inputs: ArrayLike, count: int, ninputs: int) -> Reals:
    samples = real_array("inputs", inputs)
    fitting = [(ninputs, count)] if ninputs > 1 else [(count,), (1, count)]
    if samples.shape not in fitting:
        raise ValueError(
            f"inputs must have shape {fitting[0]}, for {ninputs} of the system at {count} times, not "
            f"{samples.shape}"
        )
    return samples


def _checked_state(initial_state: ArrayLike | float, count: int) -> Reals:
    state = real_array("initial_state", initial_state)
    if state.shape not in ((), (count,)):
        raise ValueError(f"initial_state must have shape ({count},), or be one number, not {state.shape}")
    return np.broadcast_to(state, (count,)).copy()


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
    frequency = positive_number("omega", omega, "rad/s")
    gain = complex(response_at(system, frequency))
    return SteadyState(frequency, real_number("amplitude", amplitude) * abs(gain), cmath.phase(gain))
