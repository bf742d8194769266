"""Claim of chapter 7 on the frequency of the input."""

from __future__ import annotations

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
from report.chapters.appendix_a.claims.elements import friction_expression
from report.chapters.chapter_5.claims.figures_5_2_5 import LISTING
from report.chapters.chapter_7.claims.input import by_simulation, harmonic_of_output
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_input_frequency(evidence),)


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
    at_both = [
        ViscousBacklash(1.0, constant).describing_function(2.0, np.array([1e2, 1e4]))
        for constant in (1e-9, 1e3)
    ]
    return Part(
        "describing functions",
        Assertion(
            statement="those of friction- and inertia-controlled backlash do not depend on frequency",
            derived=not {omega, GAMMA} & (friction.free_symbols | inertia.free_symbols),
            evidence="with $A$, the gap and the contact angle they are complete",
            method="symbols of the derived functions",
        ),
        second_way(
            "the general element with $M/D$ of 1 ns and of 1000 s, at 100 and at 10 000 rad/s",
            all(abs(complex(np.diff(each)[0])) < 1e-4 for each in at_both),
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
        by_simulation(evidence, fifth[0]),
    )


def _split(evidence: Evidence) -> Part:
    friction, inertia = evidence.cycles.friction.stable, evidence.cycles.inertia.stable
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
        _by_orbits(evidence, inertia.frequency / friction.frequency),
    )


def _by_orbits(evidence: Evidence, ratio: float) -> Confirmation:
    """Confirm the ratio of the frequencies without friction and without inertia."""
    orbits = evidence.motion.closed.orbits
    exact = orbits.inertia.stable.frequency / orbits.friction.stable.frequency
    return Confirmation("the ratio of the exact orbits' frequencies", CloseNumbers(exact, ratio, 0.005))


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
        _by_orbits(evidence, max(stable) / min(stable)),
    )
