"""Claim on the four assumptions of the describing-function method, at the start of section 5.2."""

import control
import numpy as np
import sympy

from derivations.elements.backlash import CONTACT, friction_waveform, inertia_contact_ratio, inertia_waveform
from derivations.elements.backlash import GAP as TOTAL_GAP
from derivations.elements.friction import FORCE, relay_waveform
from derivations.elements.waveform import THETA, Waveform
from derivations.symbols import A
from report.chapters.second_ways import REPEATED
from report.judging.parts import assertion, close, small, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.friction_in_place import force_response
from report.numbers.independent.harmonics import BY_FRICTION, BY_THE_PIN, displacements
from report.numbers.independent.waveforms import coefficient
from report.numbers.limit_cycle_numbers import TIME_CONSTANTS
from report.numbers.listed_blocks import inertia_block
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash, harmonic_leakage, response_at

LITTLE = 0.05  # Share of the fundamental below which a harmonic that comes back is taken as filtered
GAP = 0.5  # Gap at which python-control's backlash is run, in any unit


@claim("txt-5.2-assumptions")
def assumptions(known: Evidence) -> Record:
    yield from _single(known)
    yield from _static_and_time_invariant()
    yield from _filtered(known)
    yield from _odd()
    yield text("""
        Each backlash by itself, and friction by itself, is one element; the two together are not, since they
        act at different places. Backlash is time-invariant, which is what the method needs. It is no function
        of the present input, since it has a memory; as an operator on the whole input it is $f(x)$. The block
        of Listing A.8, if it is one of the models, is not time-invariant. Oddness holds, and filtering holds
        at every predicted limit cycle.

        Predictions for one kind of backlash rest on good ground. Those for the equivalent nonlinearity
        (section 5.2.5) do not, and the block of Listing A.8 can only be driven.
    """)


def _single(known: Evidence) -> Record:
    numbers, pair = known.numbers, known.cycles.friction
    omegas = np.array([pair.unstable.omega, pair.stable.omega])
    pin = response_at(numbers.displacement_only, omegas) / numbers.parameters.k2
    quotients = response_at(force_response(numbers.parameters), omegas) / pin
    # Cutter against guard: its weights are the directions of friction's forces.
    by_friction, by_pin = (
        np.array([BY_FRICTION @ displacements(numbers.parameters, omega, forces) for omega in omegas])
        for forces in (BY_FRICTION, BY_THE_PIN)
    )
    solved = (by_friction / by_pin).sum()
    yield assertion(
        "1: one nonlinearity, for backlash with friction",
        "both act at one place of the loop, so that one element stands for them",
        bool(np.abs(quotients - 1).max() < 1e-6),
        f"""
        a force between cutter and guard moves them {abs(quotients)[0]:.3f} times as far at
        {pair.unstable.frequency:.0f} Hz and {abs(quotients)[1]:.3f} times as far at
        {pair.stable.frequency:.0f} Hz as a force by the pin's spring does
        """,
        method="responses of $q_2 - q_4$ to both",
        second=close("the matrices of figure 2.1, solved at both frequencies", solved, quotients.sum()),
    )


def _static_and_time_invariant() -> Record:
    library = control.friction_backlash_nonlinearity(GAP)
    from_above, from_below = ([library(start), library(0.0)][1] for start in (3 * GAP, -3 * GAP))
    rising, falling = friction_waveform().segments[3], friction_waveform().segments[1]
    difference = sympy.simplify(falling.value - rising.value)
    means = "python-control's backlash, led to the same input from above and from below"
    yield assertion(
        "2: $y(t) = f(x(t))$, for backlash",
        "the output follows from the input at the same instant",
        difference == 0,
        f"""
        where the pin falls the load is ${sympy.latex(difference)}$, a whole gap, farther than where the pin
        rises through the same place
        """,
        method="two pieces of the derived waveform at one value of the input",
        second=close(means, from_above - from_below, GAP),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    period = 1 / DRIVE_FREQUENCY
    time = np.linspace(0, period, 97, endpoint=False) + period / 1000
    delayed = time - period / 4
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * delayed)
    distance = float(np.abs(inertia_block(pin, time) - inertia_block(pin, np.mod(delayed, period))).max())
    off = f"{1e3 * distance:.1f}"
    at_rest = float(np.ptp(inertia_block(np.zeros_like(time), time)))
    means = "a pin that stands still, for which its output moves all the same"
    yield assertion(
        "2: time-invariance, for the block of Listing A.8",
        "a delayed input gives the same output, delayed",
        distance < 1e-3 * DRIVE_AMPLITUDE,
        f"for a delay of a quarter period the output is off by up to {off} mm at a stroke of 1.5 mm",
        method=REPEATED,
        second=so(means, at_rest > DRIVE_AMPLITUDE),
        certainty=Certainty.READING,
    )


def _filtered(known: Evidence) -> Record:
    system, cycles, orbits = known.numbers.displacement_only, known.cycles, known.orbits
    pairs = {"friction": cycles.friction, "inertia": cycles.inertia}
    elements = {"friction": FrictionBacklash(1.0), "inertia": InertiaBacklash(1.0)}
    limits = {
        f"{name}, {cycle.frequency:.0f} Hz": harmonic_leakage(system, elements[name], cycle, (3,))[0]
        for name, pair in pairs.items()
        for cycle in (pair.unstable, pair.stable)
    }
    between = [
        harmonic_leakage(system, ViscousBacklash(1.0, constant), cycle, (3,))[0]
        for constant, found in zip(TIME_CONSTANTS, cycles.viscous, strict=True)
        for cycle in found
    ]
    largest = max(*limits.values(), *between)
    exact = max(
        float(abs(orbit.harmonics[2] / orbit.harmonics[0]))
        for pair in (orbits.friction, orbits.inertia)
        for orbit in (pair.unstable, pair.stable)
    )
    at_limits = ", ".join(f"{100 * share:.2f} % ({name})" for name, share in limits.items())
    means = f"the exact orbits for both limits, whose third harmonics are {100 * exact:.2f} % at most"
    yield assertion(
        "3: filtering, at every predicted limit cycle",
        f"the third harmonic comes back with less than {100 * LITTLE:.0f} % of the fundamental",
        largest < LITTLE,
        f"it is {at_limits}, and at most {100 * largest:.2f} % for any $M/D$ between",
        method="the element's third harmonic with the response of $G$",
        second=so(means, exact < LITTLE),
        item="the filtering hypothesis is satisfied",
    )


def _odd() -> Record:
    waves = {
        "friction-controlled backlash": friction_waveform(),
        "inertia-controlled backlash": inertia_waveform(),
        "Coulomb friction": relay_waveform(),
    }
    one, angle = sympy.Integer(1), sympy.Rational(8, 5)
    # The gap is the one that belongs to the contact angle.
    values = {FORCE: one, A: one, CONTACT: angle, TOTAL_GAP: inertia_contact_ratio().subs(CONTACT, angle)}
    even = (one, sympy.cos(2 * THETA), sympy.sin(2 * THETA))
    for name, wave in waves.items():
        size = abs(sum(coefficient(wave, weight, values) for weight in even))
        yield assertion(
            f"4: {name}",
            "the output is odd: half a period later it is the same with the other sign",
            _repeats_with_other_sign(wave),
            "so its mean and its even harmonics are zero",
            method="the pieces of the derived waveform, compared two by two",
            second=small("quadrature of mean and second harmonic", size, 1e-12),
        )


def _repeats_with_other_sign(wave: Waveform) -> bool:
    half = len(wave.segments) // 2
    return all(
        sympy.simplify(second.start - first.start)
        == sympy.pi
        == sympy.pi + sympy.simplify(second.value.subs(THETA, THETA + sympy.pi) + first.value)
        for first, second in zip(wave.segments[:half], wave.segments[half:], strict=True)
    )
