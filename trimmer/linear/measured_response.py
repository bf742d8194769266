"""A plant that is known by its response at some frequencies alone, and how well that tells what lies between.

Between two points ln G is a cubic spline over ln omega, so that powers of omega are exact. How far off it may
be follows from an assumption: that ln G bends between two points at most ``BENDS`` times as much as the
second differences beside them tell. Then it is at most curvature (x - x1)(x2 - x)/2 from the straight line,
and the spline lies as far from that as it is seen to.
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Self, final

import control
import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline

from trimmer.arguments import real_values, shown
from trimmer.arrays import Complexes, Reals
from trimmer.linear.frequency_response import UnsupportedSystemError, response_at
from trimmer.showing.shown import Shown

FEWEST = 4  # Points that a cubic spline needs
BENDS = 2.0  # How much more ln G is taken to bend between two points than beside them
TURNS = 0.5 * np.pi
"""Change of phase from point to point, rad, from which on it is told that it is not known from data."""


@final
@dataclass(frozen=True, eq=False, repr=False)
class MeasuredResponse(Shown):
    """The response of a plant at some frequencies; between its first and its last one alone is it asked.

    Attributes:
        omega: Angular frequencies, rad/s, rising, > 0, at least four, shape (n,).
        response: G(j omega), finite and not 0, in the unit of output over input, shape (n,).

    Raises:
        UnsupportedSystemError: if they are not such.
    """

    omega: Reals
    response: Complexes

    def __post_init__(self) -> None:
        omega = real_values("omega of the data", self.omega)
        try:
            response = np.asarray(self.response, dtype=complex)
        except (TypeError, ValueError) as error:
            raise UnsupportedSystemError(
                f"response: {shown(self.response)} are no complex numbers"
            ) from error
        if omega.ndim != 1 or omega.shape != response.shape or omega.size < FEWEST:
            raise UnsupportedSystemError(
                f"frequency-response data must be as many responses as frequencies, {FEWEST} or more, not "
                f"shapes {response.shape} and {omega.shape}"
            )
        if not (np.isfinite(omega).all() and omega[0] > 0 and (np.diff(omega) > 0).all()):
            raise UnsupportedSystemError(
                "frequencies of the data must be positive and rising; leave zero out, and sort them"
            )
        if not (np.isfinite(response).all() and response.all()):
            place = float(omega[np.flatnonzero(~np.isfinite(response) | (response == 0))[0]])
            raise UnsupportedSystemError(
                f"the response at {place:.6g} rad/s is {response[omega == place][0]:.6g}: leave it out"
            )
        object.__setattr__(self, "omega", omega)
        object.__setattr__(self, "response", response)

    @classmethod
    def of(cls, data: control.FrequencyResponseData) -> Self:
        """Take frequency-response data of python-control, of one input and one output, continuous in time."""
        if not data.issiso():
            raise UnsupportedSystemError(
                f"frequency-response data of {data.ninputs} inputs and {data.noutputs} outputs are not "
                "accepted: choose one of each, as in data[0, 0]"
            )
        if data.isdtime(strict=True):
            raise UnsupportedSystemError("the system must be continuous in time, not sampled")
        return cls(np.array(data.omega), np.array(data.frdata[0, 0]))

    @property
    def ends(self) -> tuple[float, float]:
        """First and last angular frequency, rad/s."""
        return float(self.omega[0]), float(self.omega[-1])

    @property
    def doubts(self) -> tuple[str, ...]:
        """What the data do not tell of the plant between them, in sentences without a full stop."""
        told = [
            f"G is known at {self.omega.size} frequencies alone: between them ln G is a cubic spline over ln "
            "omega, and a resonance between two of them is not seen",
            f"bounds rest on the assumption that ln G bends between two points at most {BENDS:g} times as "
            "much as the second differences beside them tell; noise of the data is not in them",
        ]
        turned = np.abs(np.diff(self._logarithm.imag))
        place = int(np.argmax(turned))
        if turned[place] > TURNS:
            told.append(
                f"between {self.omega[place]:.6g} and {self.omega[place + 1]:.6g} rad/s the phase turns by "
                f"{np.degrees(turned[place]):.0f} degrees or by another way round: measure there more densely"
            )
        return tuple(told)

    def at(self, omega: ArrayLike) -> Complexes:
        """Return G(j omega) in the shape of omega, rad/s; NaN beyond the data."""
        place = real_values("omega", omega)
        inside = (place >= self.omega[0]) & (place <= self.omega[-1])
        x = np.log(np.where(inside, place, self.omega[0]))
        return np.asarray(np.where(inside, np.exp(self.logarithm(x)[0]), np.nan))

    def logarithm(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Return ln G at x = ln omega, and its derivative by x, both in the shape of x."""
        return np.asarray(self._spline(x)), np.asarray(self._spline(x, 1))

    def error(self, x: Reals) -> Reals:
        """Return how far ln G may be off between two points, under the assumption, in the shape of x."""
        knots, values = self._x, self._logarithm
        place = np.clip(np.searchsorted(knots, x, side="right") - 1, 0, knots.size - 2)
        before, after = x - knots[place], knots[place + 1] - x
        straight = (values[place] * after + values[place + 1] * before) / (before + after)
        bound = 0.5 * BENDS * self._curvature[place] * before * after
        return np.asarray(np.maximum(bound, 0.0) + np.abs(self.logarithm(x)[0] - straight))

    @cached_property
    def _x(self) -> Reals:
        return np.log(self.omega)

    @cached_property
    def _logarithm(self) -> Complexes:
        return np.asarray(np.log(np.abs(self.response)) + 1j * np.unwrap(np.angle(self.response)))

    @cached_property
    def _spline(self) -> CubicSpline:
        return CubicSpline(self._x, self._logarithm)

    @cached_property
    def _curvature(self) -> Reals:
        """Largest second difference beside each interval, (n - 1,)."""
        steps = np.diff(self._x)
        slopes = np.diff(self._logarithm) / steps
        bends = np.abs(2.0 * np.diff(slopes) / (steps[1:] + steps[:-1]))
        return np.asarray(np.maximum(np.append(bends[:1], bends), np.append(bends, bends[-1:])))

    def _told(self) -> str:
        lowest, highest = self.ends
        return f"{self.omega.size} points, {lowest:.6g} to {highest:.6g} rad/s"


def response_of(system: control.LTI | MeasuredResponse, omega: ArrayLike) -> Complexes:
    """Return G(j omega) of a system or of data, in the shape of omega, rad/s; NaN beyond data."""
    return system.at(omega) if isinstance(system, MeasuredResponse) else response_at(system, omega)


PHASES = {"phase": 1.0, "degrees": np.pi / 180.0}
FREQUENCIES = {"frequency": 2.0 * np.pi, "omega": 1.0}


def measured_response(path: Path) -> MeasuredResponse:
    """Read the response of a plant from a file of columns (CSV).

    Their names are ``frequency`` (Hz) or ``omega`` (rad/s), and ``real`` and ``imaginary``, or ``magnitude``
    or ``decibels`` with ``phase`` (rad) or ``degrees``.

    Raises:
        TableError: if the file is no table of numbers.
        UnsupportedSystemError: if a column is missing, or the numbers are no response.
    """
    from trimmer.mechanism.number_table import columns_of

    columns = columns_of(path)
    frequency, phase = (
        next((each for each in names if each in columns), "") for names in (FREQUENCIES, PHASES)
    )
    if "real" in columns and "imaginary" in columns:
        response = columns["real"] + 1j * columns["imaginary"]
    elif phase and ("magnitude" in columns or "decibels" in columns):
        size = columns["magnitude"] if "magnitude" in columns else 10.0 ** (columns["decibels"] / 20.0)
        response = size * np.exp(1j * PHASES[phase] * columns[phase])
    else:
        frequency = ""
    if not frequency:
        raise UnsupportedSystemError(
            f"{path}: the columns are {', '.join(columns)}; name them frequency (Hz) or omega (rad/s), and "
            "real and imaginary, or magnitude or decibels with phase (rad) or degrees"
        )
    try:
        return MeasuredResponse(FREQUENCIES[frequency] * columns[frequency], response)
    except UnsupportedSystemError as error:
        raise UnsupportedSystemError(f"{path}: {error}") from error
