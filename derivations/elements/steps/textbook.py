"""Describing functions of saturation, dead zone, preload and relays with hysteresis and dead zone."""

import sympy
from sympy import cos, pi, sin

from derivations.elements.friction import LEVEL
from derivations.elements.harmonics import HARMONIC, odd_harmonic
from derivations.elements.proven_step import Equality, ProvenStep, cases
from derivations.elements.textbook import (
    CORNER,
    FALL,
    FALL_RATIO,
    RATIO,
    SLOPE,
    THRESHOLD,
    dead_zone_waveform,
    preload_waveform,
    relay_by_ratio,
    relay_harmonic,
    relay_waveform,
    saturation_fundamental,
    saturation_harmonic,
    saturation_waveform,
)
from derivations.latex import latex
from derivations.step import Formula
from derivations.symbols import A

ONE = sympy.Integer(1)
THIRD = sympy.Integer(3)


def steps() -> tuple[ProvenStep, ...]:
    """Return the steps, in their order, with the equalities that are to be proven.

    Raises:
        UnprovenError: if an antiderivative is wrong or a waveform is not half-wave odd.
    """
    return saturation(), dead_zone(), preload(), relay(), limits()


def saturation() -> ProvenStep:
    """Return the step on saturation."""
    waveform = saturation_waveform()
    slope = sympy.diff(saturation_fundamental(), CORNER) / cos(CORNER)
    return ProvenStep(
        "df-saturation",
        "Saturation",
        "The output is $\\kappa x$ up to a threshold $\\Delta$, and constant beyond it. The rising input "
        "passes the threshold at $\\alpha$, with $\\Delta = A\\sin\\alpha$ and $u = \\Delta/A$. An amplitude "
        "below the threshold passes none: there $N = \\kappa$.",
        (
            cases("y", waveform.segments),
            Equality("N_1", saturation_fundamental(), odd_harmonic(waveform, A, ONE)),
            Equality("N_n", saturation_harmonic(), odd_harmonic(waveform, A, HARMONIC)),
            Equality(r"\frac{dN_1}{du}", 4 * SLOPE / pi * cos(CORNER), slope),
        ),
        code=(saturation_waveform, odd_harmonic),
    )


def dead_zone() -> ProvenStep:
    """Return the step on the dead zone."""
    waveform = dead_zone_waveform()
    return ProvenStep(
        "df-dead-zone",
        "Dead zone",
        "There is no output up to the threshold. Beyond it the output is $\\kappa$ times what the input is "
        "more. It is what a saturation leaves of a gain.",
        (
            cases("y", waveform.segments),
            Equality("N_1", SLOPE - saturation_fundamental(), odd_harmonic(waveform, A, ONE)),
            Equality("N_n", -saturation_harmonic(), odd_harmonic(waveform, A, HARMONIC)),
        ),
        code=(dead_zone_waveform, odd_harmonic),
    )


def preload() -> ProvenStep:
    """Return the step on the preload."""
    waveform = preload_waveform()
    beyond = 4 * LEVEL / (pi * HARMONIC * A)
    return ProvenStep(
        "df-preload",
        "Preload",
        "A gain and a relay: $y = \\kappa x + L \\operatorname{sign} x$.",
        (
            cases("y", waveform.segments),
            Equality("N_1", SLOPE + 4 * LEVEL / (pi * A), odd_harmonic(waveform, A, ONE)),
            # The gain has no higher harmonics, but a symbolic n may be 1 for the relay alone.
            Equality("N_3", beyond.subs(HARMONIC, THIRD), odd_harmonic(waveform, A, THIRD)),
            Equality("N_n", beyond, odd_harmonic(waveform, A, HARMONIC)),
        ),
        code=(preload_waveform, odd_harmonic),
    )


def relay() -> ProvenStep:
    """Return the step on the relay with hysteresis and dead zone."""
    waveform = relay_waveform()
    real, imaginary = cos(CORNER) + cos(FALL), sin(CORNER) - sin(FALL)
    size = 2 * LEVEL / (pi * A)
    parts = sympy.Add(size * real, -sympy.I * size * imaginary, evaluate=False)
    phases = ((sympy.asin(RATIO), CORNER), (sympy.asin(FALL_RATIO * RATIO), FALL))
    derivative = sympy.diff(relay_by_ratio(), RATIO).subs(phases)
    roots = (
        (sympy.sqrt(1 - RATIO**2), cos(CORNER)),
        (sympy.sqrt(1 - FALL_RATIO**2 * RATIO**2), cos(FALL)),
        (FALL_RATIO, sin(FALL) / RATIO),
        (RATIO, sin(CORNER)),
    )
    circle = sympy.exp(-2 * sympy.I * CORNER) / cos(CORNER) + sympy.exp(2 * sympy.I * FALL) / cos(FALL)
    return ProvenStep(
        "df-threshold-relay",
        "Relay with hysteresis and dead zone",
        "The output is $L$ from where the rising input passes the threshold $\\Delta = A\\sin\\alpha$ until "
        "the falling one passes $r\\Delta = A\\sin\\rho$. With $r = 1$ there is a dead zone alone, with "
        "$r = -1$ a hysteresis alone. The amplitude has to exceed $\\Delta$.",
        (
            cases("y", waveform.segments),
            Equality("N_n", relay_harmonic(), odd_harmonic(waveform, A, HARMONIC)),
            Equality("N_1", parts, odd_harmonic(waveform, A, ONE)),
            Equality(r"\frac{dN_1}{du}", 2 * LEVEL / (pi * THRESHOLD) * circle, derivative, given=roots),
        ),
        code=(relay_waveform, odd_harmonic),
    )


def limits() -> ProvenStep:
    """Return the step on what the elements become where a threshold or a slope vanishes."""
    ideal = 4 * LEVEL / (pi * HARMONIC * A)
    steep = saturation_harmonic().subs(SLOPE, LEVEL / (A * sin(CORNER)))
    steep_first = saturation_fundamental().subs(SLOPE, LEVEL / (A * sin(CORNER)))
    peak = sympy.pi / 2
    return ProvenStep(
        "df-textbook-limits",
        "Limits",
        "A steep saturation is a relay, and so is a preload without slope, and a relay with narrow "
        "thresholds. At an amplitude equal to the threshold a saturation is a gain, and a dead zone has no "
        "output. A dead zone and a saturation with the same threshold are a gain together.",
        (
            Formula(rf"\kappa = \frac{{L}}{{\Delta}}, \quad \Delta = {latex(A * sin(CORNER))} \to 0"),
            Equality(r"\lim N_1", ideal.subs(HARMONIC, 1), sympy.limit(steep_first, CORNER, 0)),
            Equality(r"\lim N_n", ideal, sympy.limit(steep, CORNER, 0)),
            Equality(r"N_1(A = \Delta)", SLOPE, saturation_fundamental().subs(CORNER, peak)),
            Equality(r"N_n(r = 1)", ideal * cos(HARMONIC * CORNER), relay_harmonic().subs(FALL, CORNER)),
            Equality(
                r"N_n(r = -1)",
                ideal * sympy.exp(-sympy.I * HARMONIC * CORNER),
                relay_harmonic().subs(FALL, -CORNER),
            ),
            Equality(r"N_n(\Delta = 0)", ideal, relay_harmonic().subs(((FALL, 0), (CORNER, 0)))),
            Equality(
                r"N_n^\text{dead zone} + N_n^\text{saturation}",
                sympy.Integer(0),
                odd_harmonic(dead_zone_waveform(), A, HARMONIC)
                + odd_harmonic(saturation_waveform(), A, HARMONIC),
            ),
        ),
        code=(saturation_waveform, dead_zone_waveform, relay_waveform),
    )
