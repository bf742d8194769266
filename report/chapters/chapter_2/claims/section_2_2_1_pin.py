"""Claims of section 2.2.1 on the pin's motion and velocity (equations 2.1 and 2.8)."""

from __future__ import annotations

import math

import sympy

from derivations.symbols import A, f, t, u_dot
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LinearNumbers
from trimmer import frequency_response

PIN_MOTION = A * sympy.sin(2 * sympy.pi * f * t)
AMPLITUDE_LOST = "the amplitude A is lost in the derivative"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_pin_motion(), _pin_velocity(evidence.numbers), _pin_velocity_statement(evidence.numbers))


def _pin_motion() -> Claim:
    turning_point = A * sympy.exp(2 * sympy.pi * sympy.I * f * t)
    return Claim(
        id="eq-2.1",
        parts=(Part("", SameExpression(PIN_MOTION, sympy.im(turning_point), left=sympy.Symbol("x_i"))),),
        explanation=(
            "A pin at distance $A$ from the axis of a shaft that turns $f$ times a second, seen along one "
            "direction, moves as printed. Its unit is the metre, as it must be."
        ),
        source="derivations/symbols.py",
    )


def _velocity_part() -> Part:
    printed = product(2 * sympy.pi * f, sympy.cos(2 * sympy.pi * f * t))
    derived = PIN_MOTION.diff(t)
    projected = sympy.re(2 * sympy.pi * f * A * sympy.exp(2 * sympy.pi * sympy.I * f * t))
    return Part(
        "velocity of the pin",
        SameExpression(printed, derived, left=u_dot),
        Confirmation("the velocity of a point on a circle", SameExpression(projected, derived)),
        Slip(AMPLITUDE_LOST, derived / A, Verdict.ERRATUM),
    )


def _output_with_the_slip(numbers: LinearNumbers) -> float:
    """Return the output's amplitude (m) at the drive, with the printed velocity as second input."""
    omega = 2 * math.pi * DRIVE_FREQUENCY
    gain = abs(complex(frequency_response(numbers.displacement_only, omega)))
    damper_over_spring = numbers.parameters.c2 / numbers.parameters.k2
    return gain * math.hypot(DRIVE_AMPLITUDE, damper_over_spring * omega)


def _pin_velocity(numbers: LinearNumbers) -> Claim:
    return Claim(
        id="eq-2.8",
        parts=(_velocity_part(),),
        explanation=(
            "The derivative of $A\\sin(2\\pi f t)$ keeps its amplitude, which the printed line loses. The "
            "units show it too: the printed right side is in 1/s, a velocity is in m/s."
        ),
        consequence=(
            f"The printed velocity is {1 / DRIVE_AMPLITUDE:.0f} times too large at $A = 1.5$ mm. Fed into "
            "the second input at 100 Hz, it would give figure 5.1 an amplitude of "
            f"{1e3 * _output_with_the_slip(numbers):.1f} mm; the thesis finds 1.5 mm there, and its loop "
            "drops the velocity (Listing A.1, line 58), so neither contains this slip."
        ),
        impact=Impact.LOCAL,
        source="derivations/symbols.py",
    )


def _pin_velocity_statement(numbers: LinearNumbers) -> Claim:
    rate = 2 * sympy.pi * f
    amplitude = A * rate
    at_drive = float(amplitude.subs({A: DRIVE_AMPLITUDE, f: DRIVE_FREQUENCY}))
    printed_at_drive = float(rate.subs(f, DRIVE_FREQUENCY))
    squared = sympy.trigsimp(PIN_MOTION.diff(t) ** 2 + (PIN_MOTION.diff(t, 2) / rate) ** 2)
    return Claim(
        id="txt-2.2.1-single-input-velocity",
        parts=(
            _velocity_part(),
            Part(
                "its amplitude",
                SameExpression(rate, amplitude),
                Confirmation("velocity and acceleration at any time", SameExpression(squared, amplitude**2)),
                Slip(AMPLITUDE_LOST, rate, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            f"The factor before the cosine of equation 2.8 is $2\\pi f$, {printed_at_drive:.1f}/s at "
            f"{DRIVE_FREQUENCY:.0f} Hz. The velocity of a pin with an eccentricity of "
            f"{1e3 * DRIVE_AMPLITUDE} mm has the amplitude $2\\pi f A = {at_drive:.4f}$ m/s."
        ),
        consequence=(
            "Equation 3.2 and the equations of motion take the velocity as an input. Figure 5.1 does not "
            f"contain the slip, which would make it {_output_with_the_slip(numbers) / DRIVE_AMPLITUDE:.1f} "
            "times too high; the models behind chapter 3 are not given."
        ),
        impact=Impact.LOCAL,
        source="derivations/symbols.py",
    )
