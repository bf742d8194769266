"""Claims of section 5.2.1, and of chapters 6 and 7, on how limit cycles go with the gap."""

from __future__ import annotations

from dataclasses import replace

import control

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import by_waveform
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "trimmer/balance/solve.py"
TINY_GAP = 2e-11
PLOT_OFFSET = 1e-6


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _proportional("txt-5.2.1-proportional", evidence),
        _proportional("txt-7-proportional", evidence),
        _threshold("txt-5.2.1-threshold", "2e-8", evidence.cycles),
        _threshold("txt-6-threshold", "2e-8", evidence.cycles),
    )


def _proportional(claim_id: str, evidence: Evidence) -> Claim:
    cycles, system = evidence.cycles, evidence.numbers.displacement_only
    cycle = cycles.friction.stable
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "",
                Assertion(
                    statement=(
                        "the predicted amplitude is proportional to the gap, the frequency does not depend "
                        "on it"
                    ),
                    derived=_at_a_tiny_gap(cycles).compare().agrees,
                    evidence=f"$A = {cycle.amplitude:.4f}\\,b$ at {cycle.frequency:.2f} Hz for every gap $b$",
                    method="scaling of the describing function in the gap",
                ),
                at_the_tiny_gap(system, cycle),
            ),
        ),
        explanation=(
            "$N$ depends on $b/A$ alone, so a solution $(A, \\omega)$ for the gap $b$ gives the solution "
            "$(kA, \\omega)$ for $kb$. The same holds for every kind of backlash. Contrast the statement "
            "that there is a smallest gap, which this excludes."
        ),
        source=SOURCE,
    )


def _threshold(claim_id: str, printed: str, cycles: LimitCycleNumbers) -> Claim:
    stable = cycles.friction.stable.amplitude
    seen_from = PLOT_OFFSET / (stable - 0.5)
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "smallest gap with a limit cycle",
                PrintedDigits(printed, 0.0, "m"),
                Confirmation("the scaling law, at a gap of a thousandth of that", _at_a_tiny_gap(cycles)),
            ),
        ),
        explanation=(
            "There is no threshold. $N$ depends on $b/A$ alone, so if one gap has a limit cycle every gap "
            "has one, with an amplitude in proportion: at $b = 10^{-8}$ m it is "
            f"{power_of(stable * 1e-8, 2)} m. A locus that is plotted from an amplitude of $b/2 + 10^{{-6}}$ "
            f"m on, as Listing A.9 does, meets $G$ only for gaps above {power_of(seen_from, 1)} m; another "
            "start gives another apparent threshold."
        ),
        consequence=(
            "Chapters 6 and 7 and the answer to the main question rest on this threshold. No gap is small "
            "enough to exclude the predicted limit cycle; what remains is its size, 8.3 times the gap, and "
            "whether friction and drive let it start."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def at_the_tiny_gap(system: control.TransferFunction, cycle: LimitCycle) -> Confirmation:
    """Confirm that a limit cycle, scaled down, is one of a tiny gap: by the waveform, sampled there."""
    scaled = replace(cycle, amplitude=cycle.amplitude * TINY_GAP)
    return by_waveform(system, [(FrictionBacklash(TINY_GAP), scaled)])


def _at_a_tiny_gap(cycles: LimitCycleNumbers) -> CloseNumbers:
    (cycle,) = (each for each in limit_cycles(cycles.listing, FrictionBacklash(TINY_GAP)) if each.stable)
    return CloseNumbers(cycle.amplitude / TINY_GAP, cycles.friction_listing.stable.amplitude)
