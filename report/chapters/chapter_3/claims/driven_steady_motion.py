"""What the driven trimmer can contain in the end: the theorem, and how the simulated runs agree with it."""

from __future__ import annotations

from derivations.incremental_dissipation import incremental_dissipation
from report.claim import Confirmation
from report.comparisons.printed import power_of
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

SOURCE = "derivations/incremental_dissipation.py"
METHOD = (
    "energy of the difference of two motions, derived for every positive mass, stiffness and damping, every "
    "gap and friction force"
)
SIMULATION = "exact simulation with the parameters of Listing A.1, {count} runs"
SETTLED = 1e-6
"""Share of the output by which the last two simulated periods may differ at the end of a run."""


def has_the_drives_period(evidence: Evidence) -> bool:
    """Tell whether the driven trimmer's steady motion is proven to repeat with the drive."""
    return incremental_dissipation(evidence.derivation).holds


def has_odd_harmonics_only(evidence: Evidence) -> bool:
    """Tell whether the steady motion is proven to be its own mirror image half a period later.

    With a motion its mirror image half a period later is one as well, and all motions end alike.
    """
    return incremental_dissipation(evidence.derivation).holds


def confirm_period(evidence: Evidence) -> Confirmation:
    """Confirm by the simulated runs that the steady motion repeats with the drive."""
    runs = evidence.motion.driven.runs
    return second_way(SIMULATION.format(count=len(runs)), all(run.repeat < SETTLED for run in runs))


def confirm_odd(evidence: Evidence) -> Confirmation:
    """Confirm by the simulated runs that the steady motion has odd harmonics only."""
    runs = evidence.motion.driven.runs
    return second_way(SIMULATION.format(count=len(runs)), all(run.mirror < SETTLED for run in runs))


def period_in_words(evidence: Evidence) -> str:
    """Return how the runs agree with the theorem."""
    numbers = evidence.motion.driven
    return (
        "two motions with the same pin lose the energy of their difference to dampers and friction, so all "
        f"end with the same velocities, which have the pin's period; in {len(numbers.runs)} runs with gaps "
        f"up to 20 mm the last two periods differ by {power_of(max(run.repeat for run in numbers.runs))} of "
        f"the output at most, and two starts 1 mm apart have lost all but {power_of(numbers.apart[-1])} of "
        f"that energy after {numbers.times[-1]:.1f} s"
    )
