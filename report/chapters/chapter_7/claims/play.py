"""Claims of chapter 7 on what play does to stability, and on which of its models to use."""

from __future__ import annotations

import numpy as np

from report.chapters.second_ways import ALL_LOADS, by_floquet
from report.judging.parts import assertion, close, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.loci import feedback_poles

OVERALL = "backlash leaves the stability of the whole system as it is"
FREQUENCIES = ("733", "815")
"""Frequencies of the stable limit cycles with friction and inertia alone, as chapter 6 prints them, Hz."""
CLOSE = 1e-3
"""Share by which the amplitude of a motion may differ from that of the limit cycle it ends on."""
ALIKE = 0.1
"""Share by which frequencies may differ and still be called approximately equal."""
BELOW = 0.05
"""Share by which the recommended model's amplitude may stay below another's and still stand for it."""


@claim("txt-7-only-stable")
def only_stable(known: Evidence) -> Record:
    cycle, orbit = known.cycles.friction.unstable, known.orbits.friction.unstable
    yield assertion(
        "",
        "all predicted limit cycles are stable",
        cycle.stable,
        f"""
        besides the stable one each gap $b$ has one of {cycle.amplitude:.4f} $b$ at {cycle.frequency:.2f} Hz,
        which is not
        """,
        method="all solutions of harmonic balance, Loeb's criterion",
        second=so("a Floquet multiplier of the exact orbit outside of the unit circle", not orbit.stable),
    )
    yield text(f"""
        Harmonic balance has two solutions for every gap, and the smaller one is unstable: a deviation from
        the exact orbit grows {abs(orbit.nontrivial_multipliers).max():.1f} times in each period. Read as said
        of all predicted limit cycles, the sentence contradicts table 5.1 and the answers that follow. Read as
        said of those that a motion ends on, it is right.

        The unstable one decides whether the stable one is reached: what starts inside of it comes to rest.
    """)


@claim("txt-7-play-stability")
def play_and_stability(known: Evidence) -> Record:
    stable, unstable = known.orbits.friction.stable, known.orbits.friction.unstable
    inside, outside = known.orbits.left_by
    slowest = float(feedback_poles(known.numbers.displacement_only).real.max())
    from_outside = "a motion from 0.1 % outside of the unstable orbit, which ends on it"
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    roots = float(np.roots(np.array(known.numbers.denominator, dtype=float)).real.max())
    yield assertion(
        "stability, read as that of rest",
        "play does not alter it: a small disturbance dies out",
        (slowest < 0, decay < 0),
        rf"within its play the pin does not act, and every motion decays as $e^{{{decay:.1f}\,t}}$ or faster",
        method="eigenvalues of the trimmer",
        second=close("the roots of the transfer function's denominator", roots, decay, 1e-6),
        item=OVERALL,
    )
    yield assertion(
        "stability, read as coming to rest from every start",
        "play does not alter it",
        (slowest < 0) == (not stable.stable),
        rf"""
        without play every motion decays, as $e^{{{slowest:.1f}\,t}}$ or faster; with play there is a stable
        limit cycle of {stable.amplitude:.4f} gaps
        """,
        method="eigenvalues of the closed linear loop; Floquet multipliers of the exact orbit",
        second=close(from_outside, outside, stable.amplitude, 1e-5),
        item=OVERALL,
        certainty=Certainty.READING,
    )
    outward = [each for each in unstable.nontrivial_multipliers if abs(each) > 1]
    to_either_side = (len(outward) == 1, bool(np.isreal(outward[0])), outward[0].real > 1)
    one_multiplier = "the one multiplier outside of the unit circle, which is real and positive"
    yield assertion(
        "what starts at the unstable limit cycle",
        "it goes to the stable one",
        tuple(abs(each / stable.amplitude - 1) < CLOSE for each in (inside, outside)),
        f"started 0.1 % inside it ends with {inside:.2f} gaps, 0.1 % outside with {outside:.2f} gaps",
        method="exact simulation",
        second=so(one_multiplier, to_either_side),
        item="an unstable limit cycle shifts to the stable one",
        certainty=Certainty.READING,
    )
    yield text(f"""
        Rest stays stable, and if that is meant the text is right. But without play the loop comes to rest
        from any start, with play only from small ones: beyond the unstable limit cycle it goes on for ever.
        From the unstable one towards larger amplitudes a motion does go to the stable one, which is all that
        section 5.2.3 looks at; towards smaller ones it comes to rest. Read for larger amplitudes alone, the
        sentence on the shift is right.

        The answer to the second sub-question has to read: an oscillation smaller than the unstable limit
        cycle, {unstable.amplitude:.2f} gaps, dies out, a larger one ends at {stable.amplitude:.2f} gaps.
    """)


@claim("txt-7-models")
def models(known: Evidence) -> Record:
    cycles = known.cycles
    friction, inertia = known.orbits.friction.stable, known.orbits.inertia.stable
    loads = [cycle for found in cycles.viscous for cycle in found if cycle.stable]
    counts = [sum(cycle.stable for cycle in found) for found in cycles.viscous]
    yield assertion(
        "models with play",
        "each has a stable limit cycle",
        min(counts) > 0,
        f"{max(counts)} for each of {len(counts)} loads between the limits",
        method=ALL_LOADS,
        second=by_floquet([friction, inertia], stable=True),
    )
    lowest, highest = (limit(cycle.frequency for cycle in loads) for limit in (min, max))
    merger, by_balance = cycles.equivalent.in_place.merger.frequency, cycles.inertia.stable.frequency
    yield assertion(
        "frequencies",
        "they are approximately equal",
        highest < (1 + ALIKE) * min(lowest, merger),
        f"""
        {lowest:.1f} to {highest:.1f} Hz with play alone, down to {merger:.1f} Hz with as much friction as
        leaves a limit cycle
        """,
        method="all solutions of harmonic balance for every load and every force",
        second=close("the exact orbit with inertia alone", inertia.frequency, by_balance, 0.02),
    )
    simplest, largest = cycles.friction.stable.amplitude, cycles.largest_viscous.amplitude
    smallest = min(cycle.amplitude for cycle in loads)
    yield assertion(
        "friction-controlled backlash in place of the others",
        "its limit cycle is not much smaller than that of any load",
        largest < (1 + BELOW) * simplest,
        f"it has {simplest:.2f} gaps, other loads have {smallest:.2f} to {largest:.2f}",
        method=ALL_LOADS,
        second=close("the exact orbit without inertia", friction.amplitude, simplest, 0.005),
    )
    low, high = (float(each) for each in FREQUENCIES)
    yield text(f"""
        Every kind of play has one stable limit cycle, and their frequencies lie closer together than the
        thesis's own, which are {100 * (high / low - 1):.0f} % apart. Coulomb friction alone has none, as
        section 5.2.4 says; the sentence is read as one on the models with play. The recommendation to use
        friction-controlled backlash holds: its frequency is within {100 * (highest / lowest - 1):.1f} % of
        any other load's, its amplitude at most {100 * (1 - simplest / largest):.1f} % too small and, for a
        load of inertia alone, {100 * (simplest / smallest - 1):.0f} % too large, which is the safe side.
    """)
