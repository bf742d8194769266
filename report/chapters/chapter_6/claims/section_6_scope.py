"""Claims of chapter 6 on what the method predicted, what it applies to, and what was taken into account."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import sympy

from derivations.friction import FORCE, relay_waveform
from derivations.symbols import A
from derivations.waveform import THETA
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.quadrature import coefficient, confirm
from report.comparisons.second_ways import by_grid
from report.evidence import Evidence
from trimmer import frequency_response, real_axis_crossings
from trimmer.balance.leakage import harmonic_leakage
from trimmer.balance.limit_cycle import NEAR_TANGENCY
from trimmer.elements.friction_backlash import FrictionBacklash

PHASES = 4096
SMALL = 1e-6
"""Relative step of a difference."""
WELL_PREDICTED = 0.05
"""Share by which a predicted frequency may be off and still show that the method applies."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_every_case(evidence), _hard(), _higher_terms(evidence), _tangency(evidence))


def _every_case(evidence: Evidence) -> Claim:
    cycles = evidence.cycles
    crossings = real_axis_crossings(evidence.numbers.displacement_only)
    relay = sum(crossing.value < 0 for crossing in crossings)
    viscous = sorted({len(each) for each in cycles.viscous})
    return Claim(
        id="txt-6-every-case",
        parts=(
            Part(
                "least number of limit cycles over the elements",
                PrintedDigits("1", min(2, *viscous, relay)),
                by_grid(evidence.numbers.displacement_only, relay),
                Slip("Coulomb friction is left out", min(2, *viscous), Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "Friction- and inertia-controlled backlash have two limit cycles each, viscous-controlled one or "
            "two, by its $M/D$. Coulomb friction alone, the fourth case of chapter 5, has none, as section "
            "5.2.4 says itself. That two occur under strict conditions only is not so either: they do for "
            "every gap."
        ),
        consequence="Chapter 7 repeats it: all models showed a stable limit cycle.",
        impact=Impact.LOCAL,
        source="trimmer/balance/solve.py",
    )


def _hard() -> Claim:
    cube = (A * sympy.sin(THETA)) ** 3
    gain = sympy.integrate(cube * sympy.sin(THETA), (THETA, 0, 2 * sympy.pi)) / (sympy.pi * A)
    predicted = float(sympy.sqrt(gain.subs(A, 1)))
    exact = float(mpmath.pi / (2 * mpmath.quad(lambda x: 1 / mpmath.sqrt((1 - x**4) / 2), [0, 1])))
    samples = np.sin(2 * np.pi * np.arange(PHASES) / PHASES)
    quadrature = float(2 * np.mean(samples**4))
    return Claim(
        id="txt-6.1-hard-nonlinearities",
        parts=(
            Part(
                "",
                Assertion(
                    statement="a describing function can be derived only for hard nonlinearities",
                    derived=abs(predicted / exact - 1) > WELL_PREDICTED,
                    evidence=(
                        f"the smooth $y = x^3$ has $N = {sympy.latex(gain)}$; for $\\ddot x + x^3 = 0$ it "
                        f"predicts {predicted:.4f} rad/s at $A = 1$, where {exact:.4f} rad/s is exact"
                    ),
                    method="Fourier integral of a smooth odd nonlinearity",
                ),
                Confirmation("quadrature", CloseNumbers(quadrature, complex(gain.subs(A, 1)))),
            ),
        ),
        explanation=(
            "All that the derivation in section 2.3.3 asks for is an output of the input's period; a corner "
            "or a jump does not enter. The harmonics of a smooth nonlinearity fall off faster with their "
            "number, so the method is no worse there."
        ),
        consequence=(
            "None for backlash. Smooth springs and friction that grows with speed may be treated in the same "
            "way, as a refined model of the trimmer would need."
        ),
        impact=Impact.LOCAL,
        source="derivations/waveform.py",
    )


def _higher_terms(evidence: Evidence) -> Claim:
    cycle, exact = evidence.cycles.friction.stable, evidence.motion.closed.orbits.friction.stable
    element = FrictionBacklash(1.0)
    second, third = (
        abs(complex(element.describing_function(cycle.amplitude, harmonic=each))) for each in (2, 3)
    )
    (leak,) = harmonic_leakage(evidence.numbers.displacement_only, element, cycle, (3,))
    error = abs(cycle.amplitude / exact.amplitude - 1)
    return Claim(
        id="txt-6.2-higher-terms",
        parts=(
            _index(),
            Part(
                "what accuracy asks for",
                Assertion(
                    statement="harmonic balance is accurate only if the element's higher terms vanish",
                    derived=not (third > 0.01 and error < 0.01),
                    evidence=(
                        f"at the stable limit cycle the third has {100 * third:.1f} % of the input, the "
                        f"second {100 * second:.0f} %; the amplitude is predicted to {100 * error:.2f} %"
                    ),
                    method="harmonics of friction-controlled backlash, and the exact orbit",
                ),
                Confirmation(
                    "the exact orbit by two durations",
                    CloseNumbers(
                        evidence.motion.closed.orbits.friction_by_durations[0], exact.amplitude, 1e-6
                    ),
                ),
            ),
        ),
        explanation=(
            "The index of the sine terms has slipped: $b_2 = 0$ is printed where $b_n = 0$ is meant. Nor do "
            "these coefficients, which are the element's own, vanish or need to: the linear part takes "
            f"care of them, so that {100 * leak:.2f} % of the fundamental come back as third harmonic, and "
            "that is what the error follows."
        ),
        consequence="None: the filtering hypothesis of equation 2.26 is stated rightly in section 2.3.2.",
        impact=Impact.NOTATION,
        source="trimmer/balance/leakage.py",
    )


def _index() -> Part:
    wave = relay_waveform()
    values = {FORCE: sympy.Integer(1)}
    cosines = [wave.cosine_coefficient(each) for each in (2, 3)]
    second, third = (wave.sine_coefficient(each) for each in (2, 3))
    met = all(sympy.simplify(each) == 0 for each in (*cosines, second))
    return Part(
        "$a_n = 0$ and $b_2 = 0$ for $n = 2, 3, \\dots$",
        Assertion(
            statement="where these vanish, only the fundamental is left",
            derived=not (met and sympy.simplify(third) != 0),
            evidence=f"a relay's square wave has all of these zero and $b_3 = {sympy.latex(third)}$",
            method="Fourier coefficients of the relay's waveform",
        ),
        confirm(third, coefficient(wave, sympy.sin(3 * THETA), values), values),
    )


def _angle_by_differences(evidence: Evidence) -> float:
    """Return the angle between N and -1/G at the stable limit cycle, rad."""
    cycle, around = evidence.cycles.friction.stable, np.array([1 - SMALL, 1 + SMALL])
    element = FrictionBacklash(1.0).describing_function(cycle.amplitude * around)
    inverse = -1 / frequency_response(evidence.numbers.displacement_only, cycle.omega * around)
    directions = [complex(np.diff(curve)[0]) for curve in (element, inverse)]
    angle = abs(np.angle(directions[1] / directions[0]))
    return float(min(angle, math.pi - angle))


def _tangency(evidence: Evidence) -> Claim:
    cycles = evidence.cycles
    found = [
        cycle
        for pair in (cycles.friction, cycles.inertia, cycles.friction_both_channels)
        for cycle in (pair.unstable, pair.stable)
    ] + [cycle for each in cycles.viscous for cycle in each]
    smallest = min(found, key=lambda cycle: cycle.crossing_angle)
    return Claim(
        id="txt-6.2-tangency",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the curves are nowhere nearly tangent where a limit cycle is predicted",
                    derived=smallest.crossing_angle > NEAR_TANGENCY,
                    evidence=(
                        f"they cross at {math.degrees(smallest.crossing_angle):.0f} degrees or more, over "
                        f"{len(found)} limit cycles of backlash of every kind"
                    ),
                    method="angle of $N$ and $-1/G$ at each solution of harmonic balance",
                ),
                Confirmation(
                    "small differences of both curves at the stable one of friction-controlled backlash",
                    CloseNumbers(
                        _angle_by_differences(evidence), cycles.friction.stable.crossing_angle, 1e-5
                    ),
                ),
            ),
        ),
        explanation=(
            "No prediction for backlash is in doubt for this reason. Nor do the curves touch for the gap of "
            "$2\\times10^{-8}$ m, as section 5.2.1 has it, since they are the same for every gap. What the "
            "predictions do depend on is the small distance of $G$ from $-1$ (section A.10)."
        ),
        source="trimmer/balance/limit_cycle.py",
    )
