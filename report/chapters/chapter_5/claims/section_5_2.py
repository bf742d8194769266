"""Claim on the four assumptions of the describing-function method, at the start of section 5.2."""

from __future__ import annotations

import math

import control
import numpy as np
import sympy

from derivations.backlash import CONTACT, friction_waveform, inertia_contact_ratio, inertia_waveform
from derivations.backlash import GAP as TOTAL_GAP
from derivations.friction import FORCE, relay_waveform
from derivations.symbols import A
from derivations.waveform import THETA, Waveform
from report.chapters.appendix_a.claims.time_domain import DRIVE_AMPLITUDE, DRIVE_OMEGA, PERIOD, inertia_block
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import power_of
from report.comparisons.quadrature import coefficient
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.friction_in_place import force_response
from report.numbers.impedance import BY_FRICTION, BY_THE_PIN, displacements
from report.numbers.limit_cycle_numbers import TIME_CONSTANTS
from trimmer import Body, TrimmerParameters, frequency_response
from trimmer.balance.leakage import harmonic_leakage
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

LITTLE = 0.05
"""Share of the fundamental below which a harmonic that comes back is taken as filtered."""
TURN = 2 * math.pi
GAP = 0.5
"""Gap at which python-control's backlash is run, in any unit."""
CUTTER, GUARD = Body.CUTTER.index, Body.GUARD.index
ANGLE = sympy.Rational(8, 5)
VALUES = {
    FORCE: sympy.Integer(1),
    A: sympy.Integer(1),
    CONTACT: ANGLE,
    TOTAL_GAP: inertia_contact_ratio().subs(CONTACT, ANGLE),
}
"""Values of the waveforms' symbols; the gap is the one that belongs to the contact angle."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    returned = _third_harmonics(evidence)
    return (
        Claim(
            id="txt-5.2-assumptions",
            parts=(
                _single(evidence),
                _static(),
                _time_invariant(),
                _filtered(evidence, returned),
                *_odd(),
            ),
            explanation=(
                "Each backlash by itself, and friction by itself, is one element; the two together are not, "
                "since they act at different places. Backlash has a memory, so $y = f(x)$ does not hold, but "
                "it is the same at all times, which is what the method needs; the block of Listing A.8 is "
                "not. Oddness holds, and filtering holds at every predicted limit cycle."
            ),
            consequence=(
                "Predictions for one kind of backlash rest on good ground. Those for the equivalent "
                "nonlinearity (section 5.2.5) do not, and the block of Listing A.8 can only be driven."
            ),
            impact=Impact.DOWNSTREAM,
            source="trimmer/balance/leakage.py",
        ),
    )


def _single(evidence: Evidence) -> Part:
    numbers = evidence.numbers
    omegas = np.array(
        [cycle.omega for cycle in (evidence.cycles.friction.unstable, evidence.cycles.friction.stable)]
    )
    pin = frequency_response(numbers.displacement_only, omegas) / numbers.parameters.k2
    friction = frequency_response(force_response(numbers.parameters), omegas)
    quotients = friction / pin
    return Part(
        "1: one nonlinearity, for backlash with friction",
        Assertion(
            statement="both act at one place of the loop, so that one element stands for them",
            derived=bool(np.abs(quotients - 1).max() < 1e-6),
            evidence=(
                "a force between cutter and guard moves them "
                + " and ".join(
                    f"{abs(quotient):.3f} times as far at {omega / TURN:.0f} Hz"
                    for quotient, omega in zip(quotients, omegas, strict=True)
                )
                + " as a force by the pin's spring does"
            ),
            method="responses of $q_2 - q_4$ to both",
        ),
        Confirmation(
            "the matrices of figure 2.1, solved at both frequencies",
            CloseNumbers(sum(_quotient(numbers.parameters, each) for each in omegas), quotients.sum()),
        ),
    )


def _quotient(parameters: TrimmerParameters, omega: float) -> complex:
    """Return how far friction moves cutter against guard over how far the pin's spring does."""
    friction, pin = (displacements(parameters, omega, each) for each in (BY_FRICTION, BY_THE_PIN))
    return complex((friction[CUTTER] - friction[GUARD]) / (pin[CUTTER] - pin[GUARD]))


def _static() -> Part:
    library = control.friction_backlash_nonlinearity(GAP)
    from_above, from_below = ([library(start), library(0.0)][1] for start in (3 * GAP, -3 * GAP))
    rising, falling = friction_waveform().segments[3], friction_waveform().segments[1]
    difference = sympy.simplify(falling.value - rising.value)
    return Part(
        "2: $y(t) = f(x(t))$, for backlash",
        Assertion(
            statement="the output follows from the input at the same instant",
            derived=difference == 0,
            evidence=(
                f"where the pin falls the load is ${sympy.latex(difference)}$, a whole gap, farther than "
                "where the pin rises through the same place"
            ),
            method="two pieces of the derived waveform at one value of the input",
        ),
        Confirmation(
            "python-control's backlash, led to the same input from above and from below",
            CloseNumbers(from_above - from_below, GAP),
        ),
    )


def _time_invariant() -> Part:
    time = np.linspace(0, PERIOD, 97, endpoint=False) + PERIOD / 1000
    delayed = time - PERIOD / 4
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * delayed)
    distance = float(np.abs(inertia_block(pin, time) - inertia_block(pin, np.mod(delayed, PERIOD))).max())
    return Part(
        "2: time-invariance, for the block of Listing A.8",
        Assertion(
            statement="a delayed input gives the same output, delayed",
            derived=distance < 1e-3 * DRIVE_AMPLITUDE,
            evidence=(
                "for a delay of a quarter period the output is off by up to "
                f"{1e3 * distance:.1f} mm at a stroke of {1e3 * DRIVE_AMPLITUDE:.1f} mm"
            ),
            method="the listing, repeated line by line",
        ),
        second_way(
            "a pin that stands still, for which its output moves all the same",
            float(np.ptp(inertia_block(np.zeros_like(time), time))) > DRIVE_AMPLITUDE,
        ),
    )


def _third_harmonics(evidence: Evidence) -> dict[str, float]:
    """Return the third harmonic that comes back, over the fundamental, for each predicted limit cycle."""
    system, cycles = evidence.numbers.displacement_only, evidence.cycles
    loops = [
        *(
            ("friction", FrictionBacklash(1.0), cycle)
            for cycle in (cycles.friction.unstable, cycles.friction.stable)
        ),
        *(
            ("inertia", InertiaBacklash(1.0), cycle)
            for cycle in (cycles.inertia.unstable, cycles.inertia.stable)
        ),
        *(
            (f"$M/D$ = {power_of(constant)} s", ViscousBacklash(1.0, constant), cycle)
            for constant, found in zip(TIME_CONSTANTS, cycles.viscous, strict=True)
            for cycle in found
        ),
    ]
    return {
        f"{name}, {cycle.frequency:.0f} Hz": harmonic_leakage(system, element, cycle, (3,))[0]
        for name, element, cycle in loops
    }


def _filtered(evidence: Evidence, returned: dict[str, float]) -> Part:
    orbits = evidence.motion.closed.orbits
    exact = [
        float(abs(orbit.harmonics[2] / orbit.harmonics[0]))
        for pair in (orbits.friction, orbits.inertia)
        for orbit in (pair.unstable, pair.stable)
    ]
    named = [f"{100 * share:.2f} % ({name})" for name, share in list(returned.items())[:4]]
    return Part(
        "3: filtering, at every predicted limit cycle",
        Assertion(
            statement=f"the third harmonic comes back with less than {100 * LITTLE:.0f} % of the fundamental",
            derived=max(returned.values()) < LITTLE,
            evidence=(
                f"it is {', '.join(named)}, and at most {100 * max(returned.values()):.2f} % for any "
                "$M/D$ between"
            ),
            method="the element's third harmonic with the response of $G$",
        ),
        second_way(
            f"the exact orbits for both limits, whose third harmonics are {100 * max(exact):.2f} % at most",
            max(exact) < LITTLE,
        ),
    )


def _odd() -> tuple[Part, ...]:
    elements = (
        ("friction-controlled backlash", friction_waveform()),
        ("inertia-controlled backlash", inertia_waveform()),
        ("Coulomb friction", relay_waveform()),
    )
    return tuple(
        Part(
            f"4: {name}",
            Assertion(
                statement="the output is odd: half a period later it is the same with the other sign",
                derived=_repeats_with_other_sign(wave),
                evidence="so its mean and its even harmonics are zero",
                method="the pieces of the derived waveform, compared two by two",
            ),
            Confirmation("quadrature of mean and second harmonic", CloseNumbers(1 + _even(wave), 1.0, 1e-12)),
        )
        for name, wave in elements
    )


def _even(wave: Waveform) -> complex:
    """Return the mean and both second coefficients of a waveform, added up, for one set of values."""
    weights = (sympy.Integer(1), sympy.cos(2 * THETA), sympy.sin(2 * THETA))
    return sum(coefficient(wave, weight, VALUES) for weight in weights)


def _repeats_with_other_sign(wave: Waveform) -> bool:
    half = len(wave.segments) // 2
    pairs = zip(wave.segments[:half], wave.segments[half:], strict=True)
    return all(
        sympy.simplify(second.start - first.start - sympy.pi) == 0
        and sympy.simplify(second.value.subs(THETA, THETA + sympy.pi) + first.value) == 0
        for first, second in pairs
    )
