"""Second ways and methods that claims share; what they compute is in ``report.numbers.independent``."""

from collections.abc import Sequence

import control
import sympy

from report.judging.claim import Confirmation
from report.judging.parts import close, equal, small, so
from report.numbers.independent import loci, waveforms
from report.numbers.independent.waveforms import ODD_ORDERS, Values, at_the_jump, sampled_gain
from trimmer import LimitCycle, PeriodicOrbit, response_at
from trimmer.elements import Element

DIGITS = 30
RELATIVE = 1e-12  # Accuracy of a numeric integral
CLOSES = 1e-6  # Accuracy to which a loop closes with a sampled waveform or a sum of harmonics
NEWTON = f"Newton's method in {DIGITS} digits"
EXACTLY = "exact coefficients, 40 digits"
TWO_DURATIONS = "the state at the impact and two durations, solved for with SciPy's matrix exponential"
REPEATED = "the listing, repeated line by line"
LOEB = "Loeb's criterion, from analytic derivatives of both curves"
ALL_LOADS = "all solutions of harmonic balance, $M/D$ from 1 µs to 1 s"
"""Names of ways that several claims go."""


def by_quadrature(derived: sympy.Expr, numeric: complex, values: Values) -> Confirmation:
    """Confirm a derived expression, which may be zero, at one point by a numeric integral in many digits."""
    symbolic = complex(sympy.sympify(derived).subs(values).evalf(waveforms.DIGITS))
    return small("quadrature", abs(numeric - symbolic), RELATIVE * max(1.0, abs(symbolic)))


def by_division_back(omega: float, frequency: float) -> Confirmation:
    """Confirm a conversion from rad/s to Hz by turning it round in 30 digits."""
    back = float((2 * sympy.pi * sympy.Rational(frequency)).evalf(DIGITS))
    return close(f"$2\\pi$ times it, in {DIGITS} digits", back, omega, 1e-14)


def by_grid(system: control.TransferFunction, crossings: int) -> Confirmation:
    """Confirm how often a locus crosses the negative real axis."""
    places = f"{loci.GRID.size} frequencies where $\\mathrm{{Re}}\\,G < 0$"
    return equal(f"changes of sign of $\\mathrm{{Im}}\\,G$ at {places}", loci.crossings(system), crossings)


def by_matching_real_parts(system: control.TransferFunction, share: float, count: int) -> Confirmation:
    """Confirm the number of solutions of 1 + N G = 0 for backlash with a term j 4 share/(π A), A in gaps."""
    means = f"the real part solved for the amplitude at {loci.FINE_GRID.size} frequencies"
    return equal(means, loci.solutions(system, share), count)


def by_floquet(orbits: Sequence[PeriodicOrbit], *, stable: bool) -> Confirmation:
    """Confirm that the exact orbits beside some limit cycles are all stable, or all unstable."""
    means = "the Floquet multipliers of the exact orbit" + "s" * (len(orbits) > 1)
    return so(means, tuple(orbit.stable == stable for orbit in orbits))


def by_waveform(
    system: control.TransferFunction, pairs: Sequence[tuple[Element, LimitCycle]]
) -> Confirmation:
    """Confirm limit cycles by the first line of each element's sampled waveform: N G is -1."""
    worst = max(
        abs(1 + sampled_gain(element, cycle.amplitude, cycle.omega) * complex(response))
        for element, cycle in pairs
        for response in [response_at(system, cycle.omega)]
    )
    return small("the first line in the spectrum of the waveform", worst, CLOSES)


def by_harmonics(
    system: control.TransferFunction, frequencies: Sequence[float], feedback: float = 0.0
) -> Confirmation:
    """Confirm that a square wave of each frequency (Hz) returns with zero at its jumps, by summed harmonics.

    ``feedback`` is a gain round the system beside the relay.
    """
    largest = max(abs(at_the_jump(system, frequency, feedback)) for frequency in frequencies)
    return small(f"the sum of {ODD_ORDERS.size} harmonics at the jump", largest, CLOSES)
