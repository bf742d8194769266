"""Claims of section 5.2.4 on simulated Coulomb friction: the high frequency, and scaling with the force."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.friction import FORCE
from derivations.symbols import A
from report.chapters.chapter_5.claims.section_5_2_4 import FRICTION
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import power_of
from report.comparisons.second_ways import by_harmonics, second_way
from report.evidence import Evidence
from report.numbers.relay_loop import DURATION, HALF_PERIODS, STEP, PeriodicCandidates, RelayNumbers
from report.numbers.time_stepping import FINE_STEP
from trimmer.elements.relay import Relay
from trimmer.linear import InputChannels, pin_model
from trimmer.motion.loops import ClosedLoop
from trimmer.motion.simulation import simulate

SOURCE = "report/numbers/relay_loop.py"
FIGURE_FORCE = 0.015
"""Relay of figure 5.19."""
STEADY = 1.0
"""Rate below which a frequency may be said to stay, 1/s."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_high_frequency(evidence), _linear_in_force(evidence))


def relay_part(numbers: RelayNumbers, label: str) -> Part:
    """Return the part on the oscillation of the loop with an ideal relay."""
    growth = [run.growth for run in numbers.runs]
    weakest, strongest = numbers.runs[0], numbers.runs[-1]
    return Part(
        label,
        Assertion(
            statement="an oscillation of one high frequency remains",
            derived=min(growth) < STEADY,
            evidence=(
                "the swings become smaller and faster without end: after impulses of "
                f"{power_of(weakest.impulse)} to {strongest.impulse:g} s per unit of the relay the frequency "
                f"grows as $e^{{{growth[0]:.2f}\\,t}}$ and the swings fall as "
                f"$e^{{{-2 * growth[0]:.1f}\\,t}}$"
            ),
            method="exact simulation of the loop with an ideal relay",
        ),
        Confirmation(
            "a third of the damping that G has at high frequency",
            CloseNumbers(numbers.damping / 3, growth[0], 1e-3),
        ),
    )


def friction_part(numbers: RelayNumbers, label: str) -> Part:
    """Return the part on the loop with friction and viscous friction of the output's velocity."""
    last = max(run.last_turn for run in numbers.friction)
    return Part(
        label,
        Assertion(
            statement="an oscillation remains",
            derived=last > DURATION / 2,
            evidence=(
                f"it turns for the last time within {1e6 * last:.0f} µs, and then sticks or creeps one way "
                f"for the rest of {1e3 * DURATION:.0f} ms"
            ),
            method="exact simulation with true stick, impulses over six decades",
        ),
        Confirmation(
            f"Moreau's steps of {1e9 * FINE_STEP:.0f} ns, in which a velocity of zero needs no event",
            CloseNumbers(max(numbers.last_turn_in_steps), last, 0.02),
        ),
    )


def candidates_part(candidates: PeriodicCandidates, label: str, statement: str, second: Confirmation) -> Part:
    """Return the part on periodic motions with all harmonics."""
    low, high = 0.5 / HALF_PERIODS[-1], 0.5 / HALF_PERIODS[0]
    frequencies = " and ".join(f"{frequency:.1f}" for frequency in candidates.frequencies)
    return Part(
        label,
        Assertion(
            statement=statement,
            derived=not all(candidates.in_phase),
            evidence=(
                f"from {low:g} Hz to {power_of(high)} Hz a square wave returns with zeros at its jumps at "
                f"{frequencies} Hz only, and there in phase with itself, so the relay would work against it"
            ),
            method="Tsypkin's condition in closed form, which is exact for two switchings a period",
        ),
        second,
    )


def _high_frequency(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.relay
    frequency, amplitude = numbers.sampled
    return Claim(
        id="txt-5.2.4-high-frequency",
        parts=(
            relay_part(numbers, "ideal relay on the output, after an impulse"),
            candidates_part(
                numbers.alone,
                "explanation by higher harmonics near the origin",
                "with harmonics there is a periodic motion that the describing function misses",
                by_harmonics(evidence.numbers.displacement_only, numbers.alone.frequencies),
            ),
            friction_part(numbers, "friction, which acts on velocity"),
        ),
        explanation=(
            "What is seen is the end of a motion, not a limit cycle: near the origin $G$ is a double "
            f"integrator with a little damping, on which a relay oscillates ever faster and smaller. A "
            "simulation cannot follow that; one that looks at the sign every "
            f"{1e6 * STEP:.0f} µs keeps up {frequency:.0f} Hz with {amplitude:.2f} times the relay's size, "
            "by its own delay. Harmonics do not help the explanation: Tsypkin's condition contains them all. "
            "With friction in place of the relay the loop sticks."
        ),
        consequence=(
            "That Coulomb friction may be neglected because its limit cycles are small has no ground: there "
            "are none, and in the trimmer friction decides whether backlash has one (chapter 7)."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _linear_in_force(evidence: Evidence) -> Claim:
    factor = sympy.Symbol("k", positive=True)
    scaled = FRICTION.subs({FORCE: factor * FORCE, A: factor * A}, simultaneous=True)
    difference, signal = _difference_of_scaled(evidence), sympy.Symbol("y", real=True)
    return Claim(
        id="txt-5.2.4-linear-in-fc",
        parts=(
            Part("$N(kA, kF_c) = N(A, F_c)$", SameExpression(scaled, FRICTION, left=sympy.Symbol("N"))),
            Part(
                "exact loop with a relay of 0.015 and of 0.15",
                Assertion(
                    statement="ten times the force, and the impulse, gives ten times the motion",
                    derived=difference < 1e-9,
                    evidence=(
                        f"over 20 ms the motions differ by {power_of(difference)} of the largest displacement"
                    ),
                    method="exact simulation of both",
                ),
                second_way(
                    "the relay's law, which is of first degree in signal and level",
                    factor * FORCE * sympy.sign(factor * signal) == factor * FORCE * sympy.sign(signal),
                ),
            ),
        ),
        explanation=(
            "The describing function depends on $F_c/A$ alone, so any solution scales with the force; so "
            "does the exact loop, in which the switching force is the only scale. This holds for whatever is "
            "observed, physical or numerical, and so does not show that there is a limit cycle."
        ),
        source=SOURCE,
    )


def _difference_of_scaled(evidence: Evidence) -> float:
    """Return the largest difference of two motions that are to be alike, over the largest displacement."""
    system = pin_model(evidence.numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    times = np.linspace(0, 0.02, 401)
    first, second = (
        simulate(ClosedLoop(system, Relay(force)), 0.02, impulse=1e-3 * force).output(times)
        for force in (FIGURE_FORCE, 10 * FIGURE_FORCE)
    )
    return float(np.abs(10 * first - second).max() / np.abs(second).max())
