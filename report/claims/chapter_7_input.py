"""Claims of chapter 7 on the amplitude and the frequency of the input."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    friction_waveform,
    inertia_contact_ratio,
    inertia_waveform,
)
from derivations.friction import FORCE
from derivations.symbols import A, omega
from derivations.waveform import describing_function
from report.claim import Claim, Confirmation, Impact, Part
from report.claims.appendix_a_elements import friction_expression
from report.claims.figures_5_2_5 import LISTING
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

OPEN_LOOP_GAP = 4e-5
DRIVE_AMPLITUDES = (0.0005, DRIVE_AMPLITUDE, 0.003)
TURN = 2 * math.pi
FIFTH = 5


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_input_amplitude(evidence), _input_frequency(evidence))


def harmonic_of_output(evidence: Evidence, amplitude: float, frequency: float, harmonic: int) -> float:
    """Return the amplitude of a harmonic behind backlash and linear part in open loop, m."""
    gain = FrictionBacklash(OPEN_LOOP_GAP).describing_function(amplitude, harmonic=harmonic)
    response = frequency_response(evidence.numbers.displacement_only, TURN * harmonic * frequency)
    return float(amplitude * abs(gain * response))


def _input_amplitude(evidence: Evidence) -> Claim:
    fifth = [harmonic_of_output(evidence, a, DRIVE_FREQUENCY, 5) for a in DRIVE_AMPLITUDES]
    return Claim(
        id="txt-7-input-amplitude",
        parts=(
            _open_loop(evidence),
            _dependence(evidence, fifth),
        ),
        explanation=(
            "In open loop nothing is fed back, so there is no limit cycle that could keep its amplitude: "
            "what is seen are harmonics of the drive. Scaling shows what they may depend on: input and gap "
            "times one factor give the output times that factor, so an output that did not depend on the "
            "input would be proportional to the gap. That is the limit for an input much larger than the "
            "gap, where backlash adds nearly a square wave of half the gap; from 1.5 to 3 mm the fifth "
            f"harmonic grows by {100 * (fifth[2] / fifth[1] - 1):.1f} %, which is easily taken for nothing."
        ),
        consequence=(
            "The answer holds as an approximation for wide strokes. It says nothing on a limit cycle under a "
            "drive in closed loop, which this method with one sinusoid does not reach."
        ),
        impact=Impact.LOCAL,
        source="trimmer/elements/friction_backlash.py",
    )


def _by_simulation(evidence: Evidence, fifth: float) -> Confirmation:
    """Confirm the fifth harmonic for a drive of 1.5 mm and 100 Hz, m."""
    run = next(run for run in evidence.motion.drive_amplitudes if run.amplitude == DRIVE_AMPLITUDE)
    return Confirmation(
        "exact simulation with 1.5 mm and 100 Hz", CloseNumbers(float(run.harmonics[FIFTH]), fifth, 1e-4)
    )


def _dependence(evidence: Evidence, fifth: list[float]) -> Part:
    below = FrictionBacklash(OPEN_LOOP_GAP).describing_function(0.49 * OPEN_LOOP_GAP)
    return Part(
        "what it depends on",
        Assertion(
            statement="the amplitude of the input has no effect on the oscillation that is left",
            derived=max(fifth) / min(fifth) < 1.001 and not np.isnan(below),
            evidence=(
                "for a gap of 40 µm the fifth harmonic of the output is "
                + ", ".join(f"{1e6 * a:.2f} µm" for a in fifth)
                + " for inputs of "
                + ", ".join(f"{1e3 * a:.1f} mm" for a in DRIVE_AMPLITUDES)
                + "; below half of the gap there is no output at all"
            ),
            method="fifth harmonic of the derived element times the response of $G$",
        ),
        _by_simulation(evidence, fifth[1]),
    )


def _open_loop(evidence: Evidence) -> Part:
    decay = max(mode.eigenvalue.real for mode in evidence.numbers.modes)
    return Part(
        "what oscillates in open loop",
        Assertion(
            statement="besides the drive and its harmonics a limit cycle goes on",
            derived=decay >= 0,
            evidence=(
                "the backlash repeats with the drive's period, and behind it every free motion of "
                f"the linear part decays as $e^{{{decay:.1f}\\,t}}$ or faster"
            ),
            method="periodic input of a stable linear system",
        ),
    )


def _input_frequency(evidence: Evidence) -> Claim:
    cycles = evidence.cycles
    return Claim(
        id="txt-7-input-frequency",
        parts=(
            _independent(),
            _performance(evidence),
            _split(evidence),
            _towards_friction(),
            _towards_inertia(),
            _narrow(evidence),
        ),
        explanation=(
            "That two of the functions do not depend on frequency is right, and does not make the system "
            "independent of it: $G$ does depend. The frequency in the others is that of the limit cycle, not "
            "that of the input. The function of Listing A.6 tends to backlash at high frequency because of "
            "its wrong factor, and to no kind of backlash at low frequency; friction itself does not depend "
            "on frequency at all. The range of frequencies is narrow, as stated; the amplitude still falls "
            f"by {100 * (1 - cycles.inertia.stable.amplitude / _largest(evidence)):.0f} % from its largest "
            "value to that for inertia."
        ),
        consequence=(
            "At the measured 109.945 Hz the fifth harmonic meets a resonance, which matters more than "
            "anything in this answer."
        ),
        impact=Impact.LOCAL,
        source="derivations/backlash.py",
    )


def _largest(evidence: Evidence) -> float:
    return max(cycle.amplitude for found in evidence.cycles.viscous for cycle in found if cycle.stable)


def _independent() -> Part:
    friction = describing_function(friction_waveform(), A)
    inertia = describing_function(inertia_waveform(), A).subs(GAP, A * inertia_contact_ratio())
    return Part(
        "describing functions",
        Assertion(
            statement="those of friction- and inertia-controlled backlash do not depend on frequency",
            derived=not {omega, GAMMA} & (friction.free_symbols | inertia.free_symbols),
            evidence="with $A$, the gap and the contact angle they are complete",
            method="symbols of the derived functions",
        ),
    )


def _performance(evidence: Evidence) -> Part:
    drives = (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    fifth = [harmonic_of_output(evidence, DRIVE_AMPLITUDE, drive, 5) for drive in drives]
    return Part(
        "what follows for the output",
        Assertion(
            statement="for friction-controlled backlash the input frequency changes nothing",
            derived=abs(fifth[1] / fifth[0] - 1) < 0.1,
            evidence=(
                f"behind a gap of 40 µm the fifth harmonic is {1e6 * fifth[0]:.0f} µm for a drive of "
                f"{drives[0]:.0f} Hz and {1e6 * fifth[1]:.0f} µm for one of {drives[1]} Hz"
            ),
            method="fifth harmonic of the derived element times the response of $G$",
        ),
        _by_simulation(evidence, fifth[0]),
    )


def _split(evidence: Evidence) -> Part:
    friction, inertia = evidence.cycles.friction.stable, evidence.cycles.inertia.stable
    orbits = evidence.motion.closed.orbits
    return Part(
        "condition of harmonic balance",
        Assertion(
            statement="the frequency follows from the transfer function alone",
            derived=abs(friction.omega / inertia.omega - 1) < 1e-6,
            evidence=(
                f"with the same $G$ it is {friction.frequency:.2f} Hz for friction- and "
                f"{inertia.frequency:.2f} Hz for inertia-controlled backlash"
            ),
            method="all solutions of harmonic balance for both elements",
        ),
        Confirmation(
            "the ratio of the exact orbits' frequencies",
            CloseNumbers(
                orbits.inertia.stable.frequency / orbits.friction.stable.frequency,
                inertia.frequency / friction.frequency,
                0.005,
            ),
        ),
    )


def _towards_friction() -> Part:
    added = LISTING - friction_expression()
    return Part(
        "what Listing A.6 adds to backlash, with rising frequency",
        SameExpression(sympy.Integer(0), sympy.limit(added, omega, sympy.oo), left=r"\lim (N - N_r)"),
        Confirmation(
            "its size at $10^{12}$ rad/s, raised by one",
            CloseNumbers(1 + complex(added.subs({FORCE: 1, A: 1, omega: 10**12})), 1),
        ),
    )


def _towards_inertia() -> Part:
    slow = sympy.limit(-1 / LISTING.subs({A: GAP}), omega, 0)
    angle = float(sympy.nsolve(inertia_contact_ratio() - 1, CONTACT, 1.9))
    wave = describing_function(inertia_waveform(), A).subs(GAP, A * inertia_contact_ratio())
    inertia = complex((-1 / wave).subs(CONTACT, angle).evalf())
    return Part(
        "equivalent nonlinearity, with falling frequency",
        Assertion(
            statement="the contour of Listing A.6 tends to that of inertia-controlled backlash",
            derived=abs(complex(slow) - inertia) < 1e-3,
            evidence=(
                f"at $A = b$ the listing's $-1/N$ tends to {complex(slow).real:.0f}, that of inertia is "
                f"${inertia.real:.2f} {inertia.imag:+.2f}j$"
            ),
            method="limit of the listing's function",
        ),
        Confirmation(
            "the inertia-controlled element",
            CloseNumbers(-1 / complex(InertiaBacklash(1.0).describing_function(1.0)), inertia),
        ),
    )


def _narrow(evidence: Evidence) -> Part:
    stable = [cycle.frequency for found in evidence.cycles.viscous for cycle in found if cycle.stable]
    return Part(
        "range of frequencies",
        Assertion(
            statement="stable limit cycles have nearly one frequency whatever $M/D$ is",
            derived=max(stable) / min(stable) < 1.03,
            evidence=f"from {min(stable):.1f} to {max(stable):.1f} Hz",
            method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
        ),
    )
