"""Claims on the figures of backlash before a load with inertia (figures 2.10 and 2.11). Here b is the gap."""

from __future__ import annotations

import math

import numpy as np
import sympy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from derivations.backlash import (
    CONTACT,
    GAMMA,
    SEPARATION,
    contact_force,
    contact_ratio,
    general_waveform,
    inertia_waveform,
    limits,
    separation_angle,
)
from derivations.symbols import A, omega, t
from derivations.waveform import THETA
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict, Words
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.elements.viscous_backlash import ViscousBacklash

SOURCE = "derivations/backlash.py"
PIN = A * sympy.sin(omega * t)
LOAD, PLAY = 1.7, 0.6
"""M omega / D and gap over amplitude for which the flight is integrated numerically."""
b = sympy.Symbol("b", positive=True)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_inertia_controlled(), _velocities(), _viscous_controlled())


def _inertia_controlled() -> Claim:
    flying, following, flying_back, following_back = inertia_waveform(b).segments
    return Claim(
        id="fig-2.10",
        parts=(
            Part(
                "phase of the first separation",
                SameExpression(sympy.Integer(0), limits(sympy.oo).separation, left=r"\omega t"),
                Confirmation("the start of the flight", SameExpression(flying.start, sympy.Integer(0))),
            ),
            Part(
                "phase of the second separation",
                SameExpression(sympy.pi, limits(sympy.oo).separation + sympy.pi, left=r"\omega t"),
                Confirmation("the start of the flight back", SameExpression(flying_back.start, sympy.pi)),
            ),
            Part(
                "distance of the two sides of the characteristic",
                SameExpression(b, following.value - following_back.value),
            ),
        ),
        explanation=(
            "The load separates where the pin is fastest, at $\\omega t = n\\pi$, and meets the other side "
            "of the characteristic after its free flight, as drawn."
        ),
        source=SOURCE,
    )


def _velocities() -> Claim:
    return Claim(
        id="txt-2.3.4-separation-velocity",
        parts=(*(_velocity_at_separation(number) for number in (0, 1)), _argument_of_cosine()),
        explanation=(
            "The load flies at the pin's velocity at the separation, $u' = A\\omega\\cos(n\\pi)$. The text "
            "takes that as $A\\omega$ for every $n$; for odd $n$ the pin moves the other way. Its "
            "$\\cos(\\omega n\\pi)$ puts a phase where a time belongs."
        ),
        consequence="None: the third piece of equation 2.42 has the factor $\\cos(\\omega T/2) = -1$.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _velocity_at_separation(number: int) -> Part:
    derived = PIN.diff(t).subs(t, number * sympy.pi / omega)
    after = inertia_waveform().segments[2 * number].value.diff(THETA) * omega
    return Part(
        f"velocity at the separation $n = {number}$",
        SameExpression(A * omega, derived, left="u'"),
        Confirmation("the slope of the flight", SameExpression(after, derived)),
        Slip("the sign of cos nπ is lost", derived * (-1) ** number, Verdict.ERRATUM),
    )


def _argument_of_cosine() -> Part:
    derived = PIN.diff(t).subs(t, sympy.pi / omega)
    after = inertia_waveform().segments[2].value.diff(THETA) * omega
    return Part(
        "the same for $n = 1$, as $A\\omega\\cos(\\omega n\\pi)$",
        SameExpression(A * omega * sympy.cos(omega * sympy.pi), derived, left="u'"),
        Confirmation("the slope of the flight", SameExpression(after, derived)),
        Slip("the phase nπ is put in the place of the time", PIN.diff(t).subs(t, sympy.pi), Verdict.ERRATUM),
    )


def _viscous_controlled() -> Claim:
    before = general_waveform().segments[-1].value
    angle = separation_angle()
    separation = float(angle.subs(GAMMA, LOAD))
    found, flown = _contact_angle(separation), _contact_after_flight(separation)
    return Claim(
        id="fig-2.11",
        parts=(
            Part(
                "velocity of the load before $\\phi_s$, over $\\omega$",
                SameExpression((A * sympy.sin(THETA)).diff(THETA), before.diff(THETA), left=r"\dot y/\omega"),
            ),
            Part(
                "phase $\\phi_s$ of the separation",
                SameExpression(sympy.atan(1 / GAMMA), angle, left=r"\phi_s"),
                Confirmation(
                    "a search for the zero of the contact force", CloseNumbers(_zero_of_force(), separation)
                ),
            ),
            Part(
                f"phase $\\phi_c$ of the next contact, for $\\gamma = {LOAD}$ and $b/A = {PLAY}$",
                CloseNumbers(found, flown),
                second_way(
                    "the numeric element, which touches the other side there and not before",
                    _touches(found) and not _touches(found - 1e-6),
                ),
                printed_form=Words(f"pin and load meet again at $\\phi_c = {found:.6f}$"),
                derived_form=Words(f"the flight, integrated in steps, ends at {flown:.6f}"),
            ),
        ),
        explanation=(
            "Pin and load move alike up to $\\phi_s$ and meet again at $\\phi_c$, as the text reads the "
            "figure. Equal velocities do not give $\\phi_s$, since they hold during the whole contact: it is "
            "the phase at which the contact would have to pull, $\\gamma y'' + y' = 0$. The printed equation "
            "for $\\phi_c$ has a wrong sign: see equation 2.46."
        ),
        source=SOURCE,
    )


def _touches(phase: float) -> bool:
    """Tell whether the numeric element is at the side of the gap that the pin brings up, at a phase (rad)."""
    (position,) = ViscousBacklash(PLAY, LOAD).waveform(np.array([phase]), 1.0, 1.0)
    return abs(float(position) - math.sin(phase) - PLAY / 2) < 1e-9


def _zero_of_force() -> float:
    """Return the phase at which the pushing force of the rising contact reaches zero."""
    force = sympy.lambdify(THETA, contact_force(-1).subs({GAMMA: LOAD, A: 1}), "math")
    return float(brentq(force, 0.0, math.pi / 2, xtol=1e-15))


def _contact_angle(separation: float) -> float:
    """Return the root of the derived contact equation."""
    ratio = contact_ratio().subs({SEPARATION: separation, GAMMA: LOAD}) - PLAY
    return float(brentq(sympy.lambdify(CONTACT, ratio, "math"), separation, separation + math.pi, xtol=1e-15))


def _contact_after_flight(separation: float) -> float:
    """Integrate the flight from the pin's state at separation to where it meets the other side."""

    def meets(phase: float, state: list[float]) -> float:
        return state[0] - math.sin(phase) - PLAY / 2

    meets.terminal = True  # type: ignore[attr-defined]
    start = [math.sin(separation) - PLAY / 2, math.cos(separation)]
    flight = solve_ivp(
        lambda _, state: [state[1], -state[1] / LOAD],
        (separation, separation + math.pi),
        start,
        events=meets,
        rtol=1e-12,
        atol=1e-13,
    )
    return float(flight.t_events[0][0])
