"""Saturation, dead zone, preload and relays with thresholds under a sinusoid A sin θ, from their definitions.

Sources of the definitions: Gelb and Vander Velde, Multiple-Input Describing Functions (1968), section 2.3 and
appendix B; Slotine and Li, Applied Nonlinear Control (1991), section 5.2; Atherton, Nonlinear Control
Engineering (1975), chapter 3.
"""

import sympy
from sympy import asin, cos, pi, sin

from derivations import assumed
from derivations.elements.friction import LEVEL
from derivations.elements.harmonics import HARMONIC
from derivations.elements.waveform import THETA, Segment, Waveform
from derivations.symbols import METRE, ONE, RADIAN, A, Quantity

SLOPE = assumed.positive("kappa")  # Output per input on the inclined part
CORNER = assumed.positive("alpha")  # Phase at which the rising input passes the threshold, rad
FALL = assumed.real("rho")
"""How long before the input's zero the falling output of a relay switches, rad; negative after it."""
RATIO = assumed.positive("u")  # Threshold over amplitude
FALL_RATIO = assumed.real("r")  # Threshold of the falling output over that of the rising one
THRESHOLD = assumed.positive("Delta")  # Threshold, in the unit of the input

TEXTBOOK_QUANTITIES = (
    Quantity(SLOPE, "slope of an element, output per input", ONE),
    Quantity(CORNER, "phase at which the rising input passes the threshold", RADIAN),
    Quantity(FALL, "phase before the input's zero at which the falling output of a relay switches", RADIAN),
    Quantity(RATIO, "threshold over amplitude", ONE),
    Quantity(FALL_RATIO, "threshold of the falling output over that of the rising one", ONE),
    Quantity(THRESHOLD, "threshold", METRE),
)
HELD = A * sin(CORNER)  # The threshold, by the phase at which the input passes it


def four_parts(inside: sympy.Expr, beyond: sympy.Expr) -> Waveform:
    """Return an odd output with corners at ±``CORNER`` about each zero of the input.

    Args:
        inside: Output between the thresholds, in ``THETA``.
        beyond: Output above the upper one; below the lower one it has the other sign.
    """
    below = beyond.subs(THETA, THETA - pi)
    return Waveform(
        (
            Segment(-CORNER, CORNER, inside),
            Segment(CORNER, pi - CORNER, beyond),
            Segment(pi - CORNER, pi + CORNER, -inside.subs(THETA, THETA - pi)),
            Segment(pi + CORNER, 2 * pi - CORNER, -below),
        )
    )


def saturation_waveform() -> Waveform:
    """Return κ x up to the threshold, and κ times the threshold beyond it."""
    return four_parts(SLOPE * A * sin(THETA), SLOPE * HELD)


def dead_zone_waveform() -> Waveform:
    """Return zero up to the threshold, and κ times what x is beyond it."""
    return four_parts(sympy.Integer(0), SLOPE * (A * sin(THETA) - HELD))


def preload_waveform() -> Waveform:
    """Return κ x + L sign x."""
    force = SLOPE * A * sin(THETA)
    return Waveform((Segment(sympy.Integer(0), pi, force + LEVEL), Segment(pi, 2 * pi, force - LEVEL)))


def relay_waveform() -> Waveform:
    """Return L from where the rising input passes A sin α until the falling one passes A sin ρ; -L below."""
    nothing = sympy.Integer(0)
    return Waveform(
        (
            Segment(CORNER, pi - FALL, LEVEL),
            Segment(pi - FALL, pi + CORNER, nothing),
            Segment(pi + CORNER, 2 * pi - FALL, -LEVEL),
            Segment(2 * pi - FALL, 2 * pi + CORNER, nothing),
        )
    )


def saturation_fundamental() -> sympy.Expr:
    """Return N_1 of a saturation, of the phase of the corner."""
    return SLOPE * (2 * CORNER + sin(2 * CORNER)) / pi


def saturation_harmonic() -> sympy.Expr:
    """Return N_n of a saturation for odd n >= 3."""
    n = HARMONIC
    turned = n * sin(n * CORNER) * cos(CORNER) - cos(n * CORNER) * sin(CORNER)
    return 4 * SLOPE * turned / (pi * n * (n**2 - 1))


def relay_harmonic() -> sympy.Expr:
    """Return N_n of a relay with thresholds for odd n."""
    middle, apart = (CORNER + FALL) / 2, (CORNER - FALL) / 2
    size = 4 * LEVEL / (pi * HARMONIC * A)
    return size * cos(HARMONIC * middle) * sympy.exp(-sympy.I * HARMONIC * apart)


def relay_by_ratio() -> sympy.Expr:
    """Return N_1 of a relay of u = Δ/A, with r Δ for the other threshold."""
    angles = asin(RATIO), asin(FALL_RATIO * RATIO)
    both = sympy.exp(-sympy.I * angles[0]) + sympy.exp(sympy.I * angles[1])
    return 2 * LEVEL / (pi * THRESHOLD) * RATIO * both
