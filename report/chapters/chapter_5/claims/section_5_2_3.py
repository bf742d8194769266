"""Claims of section 5.2.3 on predictions for viscous-controlled backlash (equations 5.10 and 5.11)."""

from __future__ import annotations

import math

import sympy

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.comparisons.second_ways import by_division_back, by_floquet, by_waveform
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import TIME_CONSTANTS, friction_exactly, inertia_by_newton
from trimmer.elements.viscous_backlash import ViscousBacklash

SOURCE = "trimmer/elements/viscous_backlash.py"
TURN = 2 * math.pi
ROUNDED = "the coefficients of Listing A.9, rounded to four digits, are used"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _band(evidence),
        _harmonic_balance(),
        _inner(evidence),
        _only_between(evidence),
        _identify(evidence),
    )


def _band(evidence: Evidence) -> Claim:
    cycles = evidence.cycles
    low, high = cycles.friction.stable, cycles.inertia.stable
    both = (cycles.friction_both_channels.stable.frequency, cycles.inertia_both_channels.stable.frequency)
    _, omega = inertia_by_newton(evidence.numbers, high)
    _, low_omega = friction_exactly(evidence.numbers, low)
    return Claim(
        id="eq-5.10",
        parts=(
            Part(
                "lower end",
                PrintedDigits("733", low.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(low_omega / TURN, low.frequency)),
                Slip(ROUNDED, cycles.friction_listing.stable.frequency, Verdict.EXPLAINED),
            ),
            Part(
                "upper end",
                PrintedDigits("815", high.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega / TURN, high.frequency)),
            ),
        ),
        explanation=(
            f"The ends are the two limits of the load: {low.frequency:.1f} Hz without inertia and "
            f"{high.frequency:.1f} Hz without friction. The upper one repeats the wrong prediction of "
            "section 5.2.2."
        ),
        consequence=(
            f"The band is {high.frequency - low.frequency:.0f} Hz wide instead of 82 Hz. With the pin's "
            f"velocity as second input it runs from {both[0]:.1f} to {both[1]:.1f} Hz."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/solve.py",
    )


def _harmonic_balance() -> Claim:
    element, linear = sympy.symbols("N G")
    return Claim(
        id="eq-5.11",
        parts=(Part("", SameExpression(total(element * linear, 1), sympy.expand(1 - linear * (-element)))),),
        explanation=(
            "For a measured frequency these are two real equations for $b/A$ and $M\\omega/D$, as many as "
            "unknowns. The driving frequency, which the text asks for, does not appear: the frequency in "
            "$\\gamma$ is that of the limit cycle."
        ),
        source="report/chapters/chapter_5/claims/section_5_2_3.py",
    )


def _inner(evidence: Evidence) -> Claim:
    unstable = [cycle for cycles in evidence.cycles.viscous for cycle in cycles if cycle.omega < 4000]
    orbits = evidence.motion.closed.orbits
    return Claim(
        id="txt-5.2.3-unstable-inner",
        parts=(
            Part(
                "",
                Assertion(
                    statement="all limit cycles on the inner part of the locus are unstable",
                    derived=bool(unstable) and not any(cycle.stable for cycle in unstable),
                    evidence=(
                        f"{len(unstable)} of them over {len(TIME_CONSTANTS)} values of $M/D$, none stable by "
                        "Loeb's criterion"
                    ),
                    method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
                ),
                by_floquet([orbits.friction.unstable, orbits.inertia.unstable], stable=False),
            ),
        ),
        explanation=(
            "True by Loeb's criterion. The text lets them merge with the stable ones; they do not: a motion "
            "that starts near one either decays or grows to the stable one. For $M/D$ near 0.1 ms there is "
            "no inner one at all."
        ),
        source="trimmer/balance/stability.py",
    )


def _only_between(evidence: Evidence) -> Claim:
    cycles = evidence.cycles
    low, high = cycles.friction.stable.frequency, cycles.inertia.stable.frequency
    stable = [cycle for each in cycles.viscous for cycle in each if cycle.stable]
    loads = [ViscousBacklash(1.0, time_constant) for time_constant in TIME_CONSTANTS]
    frequencies = [cycle.frequency for cycle in stable]
    return Claim(
        id="txt-5.2.3-band",
        parts=(
            Part(
                "",
                Assertion(
                    statement="stable limit cycles lie between the frequencies of the two limits",
                    derived=low - 1e-3 <= min(frequencies)
                    and max(frequencies) <= high + 1e-3
                    and len(stable) == len(TIME_CONSTANTS),
                    evidence=(
                        f"one for each $M/D$, with a frequency that rises from {min(frequencies):.2f} to "
                        f"{max(frequencies):.2f} Hz"
                    ),
                    method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
                ),
                by_waveform(evidence.numbers.displacement_only, list(zip(loads, stable, strict=True))),
            ),
        ),
        explanation=(
            "For this trimmer there is exactly one stable limit cycle for every load, and its frequency lies "
            "between the limits, whose values in equation 5.10 are wrong. The amplitude is not bounded by "
            f"them: it reaches {cycles.largest_viscous.amplitude:.2f} gaps, where the limits have "
            f"{cycles.friction.stable.amplitude:.2f} and {cycles.inertia.stable.amplitude:.2f}."
        ),
        source="trimmer/balance/solve.py",
    )


def _identify(evidence: Evidence) -> Claim:
    highest = max(cycle.frequency for each in evidence.cycles.viscous for cycle in each if cycle.stable)
    return Claim(
        id="txt-5.2.3-identify-760",
        parts=(
            Part(
                "conversion",
                PrintedDigits("4775", 760 * TURN, "rad/s"),
                by_division_back(760 * TURN, 760),
            ),
            Part(
                "a ratio M/D for 760 Hz",
                Assertion(
                    statement="a measured 760 Hz gives a ratio $M/D$",
                    derived=highest >= 760,
                    evidence=(
                        "no $M/D$ has a stable limit cycle above "
                        f"{evidence.cycles.inertia.stable.frequency:.2f} Hz"
                    ),
                    method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
                ),
                Confirmation(
                    "Newton's method in 30 digits, for the limit without friction",
                    CloseNumbers(
                        inertia_by_newton(evidence.numbers, evidence.cycles.inertia.stable)[1],
                        evidence.cycles.inertia.stable.omega,
                    ),
                ),
            ),
        ),
        explanation=(
            "The conversion is right. The example lies outside of what the model can give, for any load; in "
            "the printed band of equation 5.10 it looks possible."
        ),
        consequence=(
            "The proposed experiment keeps its sense, with a band less than a quarter as wide to resolve."
        ),
        impact=Impact.LOCAL,
        source="trimmer/balance/solve.py",
    )
