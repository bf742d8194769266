"""The formulas that the corrected listings print, each taken from the derivations."""

from dataclasses import dataclass

import sympy

from derivations import assumed
from derivations.elements.backlash import (
    CONTACT,
    GAP,
    SEPARATION,
    contact_ratio,
    friction_waveform,
    general_waveform,
    inertia_contact_ratio,
    inertia_waveform,
)
from derivations.elements.friction import friction_waveform as coulomb_waveform
from derivations.elements.waveform import THETA, Waveform, segment_integral
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import A

RATIO = assumed.positive("beta")  # Total gap over the amplitude of the pin
FLIGHT = assumed.positive("delta")  # Angle of free flight, from separation to contact, rad
STIFFNESS = assumed.positive("k")  # Stiffness that makes a number of a friction term, N/m
PIN, LOAD = assumed.real("x y")  # Position of the pin, and the load's position until now, m


@dataclass(frozen=True)
class GainParts:
    """Real and imaginary part of a describing function."""

    real: sympy.Expr
    imaginary: sympy.Expr


@dataclass(frozen=True)
class TransferCoefficients:
    """Coefficients of the transfer function from the pin to one output, highest power first.

    ``displacement_only`` is the numerator that the thesis keeps, ``both_channels`` has the velocity too.
    """

    displacement_only: tuple[sympy.Expr, ...]
    both_channels: tuple[sympy.Expr, ...]
    denominator: tuple[sympy.Expr, ...]


def transfer_coefficients(derivation: LinearTrimmer, weights: tuple[sympy.Expr, ...]) -> TransferCoefficients:
    """Return the coefficients for a sum of the displacements q1 to q4 with these weights."""
    transfer = derivation.transfer
    by_displacement, by_velocity = (
        tuple(
            sympy.Add(*(weight * coefficient for weight, coefficient in zip(weights, power, strict=True)))
            for power in zip(*numerators, strict=True)
        )
        for numerators in (transfer.from_displacement, transfer.from_velocity)
    )
    # The velocity is s times the displacement, which moves its numerator up by one power.
    zero = sympy.Integer(0)
    both = zip((zero, *by_displacement), (*by_velocity, zero), strict=True)
    return TransferCoefficients(
        by_displacement, tuple(first + second for first, second in both), transfer.denominator
    )


def pin_input(derivation: LinearTrimmer) -> sympy.MatrixBase:
    """Return b of z' = A z + b u with z = x - B2 u, for a pin whose displacement is u and velocity u'."""
    space = derivation.space
    return space.b[:, 0] + space.a * space.b[:, 1]


def friction_gain() -> GainParts:
    """Return N of friction-controlled backlash as a function of ``RATIO``."""
    return _gain(friction_waveform(), A * RATIO)


def friction_step() -> sympy.Expr:
    """Return the position that a load without inertia takes when the pin has moved.

    The walls are where the waveform follows the pin; the load stays unless one of them pushes it.
    """
    values = (segment.value.subs(A * sympy.sin(THETA), PIN) for segment in friction_waveform().segments)
    lower, upper = sorted((value for value in values if value.has(PIN)), key=lambda wall: wall.coeff(GAP))
    return sympy.Max(sympy.Min(LOAD, upper), lower)


def inertia_gain() -> GainParts:
    """Return N of inertia-controlled backlash as a function of the contact angle."""
    return _gain(inertia_waveform(), A * inertia_contact_ratio())


def inertia_motion() -> sympy.Expr:
    """Return the steady position of a load without friction over the phase of the pin, from 0 to 2π."""
    *first, last = inertia_waveform().segments
    return sympy.Piecewise(*((segment.value, segment.end > THETA) for segment in first), (last.value, True))


def general_ratio() -> sympy.Expr:
    """Return gap over amplitude of the general backlash as a function of γ, separation and flight."""
    return _over_flight(contact_ratio())


def general_gain() -> GainParts:
    """Return N of the general backlash as a function of γ, ``RATIO``, separation and flight.

    Half of the waveform is integrated; the other half is the same half a period later, with the other sign.
    """
    first_half = general_waveform().segments[:2]
    real, imaginary = (
        sympy.Add(*(segment_integral(segment, weight) for segment in first_half))
        for weight in (sympy.sin(THETA), sympy.cos(THETA))
    )
    return GainParts(
        *(_over_flight((2 * part / sympy.pi / A).subs(GAP, RATIO * A)) for part in (real, imaginary))
    )


def friction_term() -> sympy.Expr:
    """Return the imaginary part of Coulomb friction's N under a displacement, over ``STIFFNESS``."""
    return sympy.expand(coulomb_waveform().cosine_coefficient() / A / STIFFNESS)


def _gain(waveform: Waveform, gap: sympy.Expr) -> GainParts:
    coefficients = (waveform.sine_coefficient(), waveform.cosine_coefficient())
    return GainParts(*(sympy.expand((coefficient / A).subs(GAP, gap)) for coefficient in coefficients))


def _over_flight(expression: sympy.Expr) -> sympy.Expr:
    """Put the flight in place of the contact angle: then no exponential is large."""
    over_flight = sympy.expand(sympy.expand(expression).subs(CONTACT, SEPARATION + FLIGHT))
    return sympy.factor_terms(sympy.powsimp(over_flight))
