"""Every number of the linear trimmer that claims and figures need, solved once, and trimmers beside it.

Exact coefficients come from the derivation with the listing's parameters as fractions; everything else from
the numeric twin.
"""

from dataclasses import dataclass, replace
from fractions import Fraction

import control
import numpy as np
import sympy

from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import PARAMETERS
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import TrimmerParameters, modes, pin_model, transfer_function
from trimmer.arrays import Reals
from trimmer.generated import linear_trimmer
from trimmer.linear import InputChannels, Mode, UndampedMode, time_response, undamped_modes

FIRST_PERIOD = 1 / DRIVE_FREQUENCY
SAMPLES_PER_SECOND = 100_000
DAMPING_FACTOR = 1e-3  # Of figure 5.4; the thesis does not give its own factor


@dataclass(frozen=True)
class StartFromRest:
    """The drive of figure 5.1 applied to the trimmer at rest.

    ``deviation`` is the largest difference between output and pin in the first period, m;
    ``settled_amplitude`` is half of peak to peak in the last simulated period, m.
    """

    deviation: float
    settled_amplitude: float


@dataclass(frozen=True)
class LinearNumbers:
    """Results for the thesis's trimmer, output cutter relative to guard.

    ``numerator`` and ``denominator`` hold exact coefficients, highest power first, of the transfer function
    from the pin's displacement alone; ``numerators`` those of each displacement q1 to q4.
    """

    parameters: TrimmerParameters
    numerators: tuple[tuple[Fraction, ...], ...]
    denominator: tuple[Fraction, ...]
    displacement_only: control.TransferFunction
    both_channels: control.TransferFunction
    modes: tuple[Mode, ...]
    undamped: tuple[UndampedMode, ...]
    start: StartFromRest

    @property
    def numerator(self) -> tuple[Fraction, ...]:
        """Exact coefficients for q2 − q4."""
        return self.combined_numerator({1: 1, 3: -1})

    def combined_numerator(self, weights: dict[int, int]) -> tuple[Fraction, ...]:
        """Return exact coefficients for a sum of displacements with integer weights (index from 0)."""
        powers = range(len(self.numerators[0]))
        return tuple(
            sum((weight * self.numerators[row][power] for row, weight in weights.items()), Fraction(0))
            for power in powers
        )


def solve_linear(derivation: LinearTrimmer, parameters: TrimmerParameters) -> LinearNumbers:
    """Solve everything for one set of parameters."""
    exact = exact_values(parameters)
    return LinearNumbers(
        parameters=parameters,
        numerators=tuple(_exact(row, exact) for row in derivation.transfer.from_displacement),
        denominator=_exact(derivation.transfer.denominator, exact),
        displacement_only=transfer_function(parameters, channels=InputChannels.DISPLACEMENT_ONLY),
        both_channels=transfer_function(parameters, channels=InputChannels.DISPLACEMENT_AND_VELOCITY),
        modes=modes(parameters),
        undamped=undamped_modes(parameters),
        start=_start_from_rest(parameters),
    )


def exact_values(parameters: TrimmerParameters) -> dict[sympy.Expr, sympy.Rational]:
    """Return the parameters as the fractions that their decimal digits stand for."""
    return {
        quantity.symbol: sympy.Rational(repr(value))
        for quantity, value in zip(PARAMETERS, parameters.values(), strict=True)
    }


def _exact(
    coefficients: tuple[sympy.Expr, ...], values: dict[sympy.Expr, sympy.Rational]
) -> tuple[Fraction, ...]:
    rationals = (sympy.Rational(coefficient.subs(values)) for coefficient in coefficients)
    return tuple(Fraction(int(rational.p), int(rational.q)) for rational in rationals)


def _start_from_rest(parameters: TrimmerParameters) -> StartFromRest:
    times = np.arange(0, 0.4, 1 / SAMPLES_PER_SECOND)
    pin, output = pin_and_output(parameters, times)
    first, last = times < FIRST_PERIOD, times > times[-1] - FIRST_PERIOD
    return StartFromRest(
        deviation=float(np.abs(output - pin)[first].max()), settled_amplitude=float(np.ptp(output[last]) / 2)
    )


def pin_and_output(parameters: TrimmerParameters, times: Reals) -> tuple[Reals, Reals]:
    """Return pin and output of the thesis's model from rest, m, (n,) each, at equally spaced times, s."""
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * times)
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    return pin, time_response(system, times, pin).outputs


def lightly_damped(parameters: TrimmerParameters) -> TrimmerParameters:
    """Return the same trimmer with ``DAMPING_FACTOR`` of its damping."""
    dampings = {name: DAMPING_FACTOR * getattr(parameters, name) for name in ("c1", "c2", "c3", "c4")}
    return replace(parameters, **dampings)


def lightly_damped_response(parameters: TrimmerParameters) -> control.TransferFunction:
    """Return the transfer function of the thesis's output with little damping."""
    return transfer_function(lightly_damped(parameters), channels=InputChannels.DISPLACEMENT_ONLY)


def sum_of_displacements(parameters: TrimmerParameters) -> control.TransferFunction:
    """Return the transfer function from pin displacement to q1 + q2 + q3 + q4 (thesis, equation 5.3)."""
    values = parameters.values()
    numerator = np.sum(linear_trimmer.displacement_numerators(*values), axis=0)
    return control.tf(numerator, np.array(linear_trimmer.characteristic_polynomial(*values)))
