"""-1/G of many trimmers: the derived polynomials, with a row for each."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import ArrayRecord, Complexes, Reals
from trimmer.displacement import Displacement
from trimmer.ensembles.polynomials import on_axis, value_and_slope
from trimmer.generated import linear_trimmer
from trimmer.linear.model import InputChannels


@dataclass(frozen=True)
class Responses(ArrayRecord):
    """G = numerator / denominator, (n, 8) and (n, 9), monic; s in units of ``reference``, rad/s, (n,)."""

    numerator: Reals
    denominator: Reals
    reference: Reals

    def inverse(self, omegas: Reals) -> Complexes:
        """Return -1/G at each trimmer's own omegas / reference, shape (n, points)."""
        with np.errstate(all="ignore"):
            return np.asarray(-on_axis(self.denominator, omegas) / on_axis(self.numerator, omegas))

    def inverse_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Return -1/G and its derivative by x = ln(omega / reference), one for each trimmer, shape (n,)."""
        s = 1j * np.exp(x)
        top, top_slope = value_and_slope(self.denominator.astype(complex), s)
        bottom, bottom_slope = value_and_slope(self.numerator.astype(complex), s)
        with np.errstate(all="ignore"):
            inverse = -top / bottom
            return inverse, inverse * s * (top_slope / top - bottom_slope / bottom)


def responses_of(values: Reals, output: Displacement, channels: InputChannels) -> Responses:
    """Build the responses from derived coefficients, of values in the order of the parameters, (n, 13)."""
    columns = tuple(np.ascontiguousarray(values.T))
    count = len(values)
    denominator = _stacked(linear_trimmer.characteristic_polynomial(*columns), count)
    numerator = np.zeros((count, 8))
    with np.errstate(all="ignore"):
        for weight, row in zip(output.row, linear_trimmer.displacement_numerators(*columns), strict=True):
            if weight:
                numerator[:, 1:] += weight * _stacked(row, count)
        if channels is InputChannels.DISPLACEMENT_AND_VELOCITY:
            for weight, row in zip(output.row, linear_trimmer.velocity_numerators(*columns), strict=True):
                if weight:
                    numerator[:, :-1] += weight * _stacked(row, count)
        reference = denominator[:, -1] ** (1.0 / 8.0)
        powers = reference[:, None] ** np.arange(9)
        return Responses(numerator / powers[:, 1:], denominator / powers, reference)


def _stacked(row: tuple[object, ...], count: int) -> Reals:
    return np.stack([np.broadcast_to(np.asarray(each, dtype=float), (count,)) for each in row], axis=1)
