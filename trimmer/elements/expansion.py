"""A describing function next to a point: its value, its derivatives, and bounds of these on a box.

The variables are u = amplitude_scale / amplitude and ln omega. As both are numbers, all fields are in the
unit of N, output over input, and have the shape that the arguments broadcast to.
"""

from typing import NamedTuple

from trimmer.arrays import Complexes, Reals


class Derivatives(NamedTuple):
    """Derivatives of the first harmonic's N: by u at constant omega, by ln omega at constant amplitude."""

    by_u: Complexes
    by_log_omega: Complexes


class Expansion(NamedTuple):
    """The first harmonic's N and its ``Derivatives`` at the same points."""

    value: Complexes
    by_u: Complexes
    by_log_omega: Complexes


class GainSensitivity(NamedTuple):
    """Upper bounds of the moduli of ``Derivatives`` on a box of u and omega."""

    by_u: Reals
    by_log_omega: Reals


class GainVariation(NamedTuple):
    """Upper bounds of how much ``Derivatives`` differ between two points of a box of u and omega."""

    by_u: Reals
    by_log_omega: Reals
