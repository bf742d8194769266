"""Random trimmers and random systems for the property tests, and the thesis's trimmer in exact numbers."""

import control
import mpmath
import numpy as np
from hypothesis import strategies as st

from trimmer import TrimmerParameters

MASSES = ("m1", "m2", "m3", "m4")
STIFFNESSES = ("k1", "k2", "k3", "k4", "k5")
DAMPINGS = ("c1", "c2", "c3", "c4")


def _powers_of_ten(lowest: float, highest: float) -> st.SearchStrategy[float]:
    return st.floats(lowest, highest).map(lambda exponent: 10**exponent)


def trimmers() -> st.SearchStrategy[TrimmerParameters]:
    """Damped trimmers with every spring and damper there, each parameter within two decades."""
    sizes = {
        **dict.fromkeys(MASSES, _powers_of_ten(-3, -1)),
        **dict.fromkeys(STIFFNESSES, _powers_of_ten(4, 6)),
        **dict.fromkeys(DAMPINGS, _powers_of_ten(-1, 1)),
    }
    return st.builds(TrimmerParameters, **sizes)


@st.composite
def stable_systems(draw: st.DrawFn) -> control.TransferFunction:
    """Stable strictly proper systems of order 2 to 5, with light and strong damping, zeros on both sides."""
    pairs = draw(st.integers(1, 2))
    denominator = np.poly1d([1.0])
    for _ in range(pairs):
        omega, damping = draw(_powers_of_ten(-1, 1)), draw(_powers_of_ten(-4, 0.3))
        denominator *= np.poly1d([1.0, 2 * damping * omega, omega**2])
    if draw(st.booleans()):
        denominator *= np.poly1d([1.0, draw(_powers_of_ten(-1, 1))])
    numerator = np.poly1d([draw(st.sampled_from([-3.0, 1.0, 20.0]))])
    for _ in range(draw(st.integers(0, denominator.order - 1))):
        numerator *= np.poly1d([1.0, draw(st.sampled_from([-1.0, 1.0])) * draw(_powers_of_ten(-1, 1))])
    return control.tf(numerator.coeffs, denominator.coeffs)


def exact_displacements(
    parameters: TrimmerParameters, omega: float, velocity_too: bool = False
) -> tuple[mpmath.mpc, ...]:
    """Response q1 to q4 to the pin, from the balance of forces on each body, to 30 digits.

    Written from the figure of the thesis and not from the derivation, to have something to hold it against.
    """
    with mpmath.workdps(30):
        m1, m2, m3, m4, k1, k2, k3, k4, k5, c1, c2, c3, c4 = map(mpmath.mpf, parameters.values())
        s = mpmath.mpc(0, omega)
        mount, bridge, housing, guard = (c * s + k for c, k in ((c1, k1), (c2, k2), (c3, k3), (c4, k4)))
        balance = mpmath.matrix(
            [
                [m1 * s**2 + mount + bridge, -bridge, 0, 0],
                [-bridge, m2 * s**2 + bridge + k5, -k5, 0],
                [0, -k5, m3 * s**2 + housing + guard + k5, -guard],
                [0, 0, -guard, m4 * s**2 + guard],
            ]
        )
        force = bridge if velocity_too else k2
        return tuple(mpmath.lu_solve(balance, mpmath.matrix([-force, force, 0, 0])))


def exact_response(omega: float, velocity_too: bool = False) -> mpmath.mpc:
    """Response q2 - q4 of the thesis's trimmer to the pin, to 30 digits."""
    q = exact_displacements(TrimmerParameters.thesis(), omega, velocity_too)
    return q[1] - q[3]
