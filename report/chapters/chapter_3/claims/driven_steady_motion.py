"""What the driven trimmer can contain in the end: the theorem, how the runs agree with it, and harmonics."""

from collections.abc import Sequence

from derivations.elements.incremental_dissipation import incremental_dissipation
from report.judging.claim import Confirmation
from report.judging.comparisons.printed import power_of
from report.judging.parts import close, so
from report.judging.text import one_line
from report.numbers.driven_motion import FORCES, STARTED_ASIDE, DrivenRun
from report.numbers.evidence import Evidence
from report.numbers.independent.harmonics import harmonic_behind, harmonic_of_friction
from report.numbers.thesis import DRIVE_AMPLITUDE, MEASURED_DRIVE_OMEGA
from trimmer import FrictionBacklash

METHOD = one_line(
    """
    energy of the difference of two motions, derived for every positive mass, stiffness and damping, every gap
    and friction force
    """
)
BY_LISTING = "exact simulation with the parameters of Listing A.1"
SETTLED = 1e-6  # Share of the output by which the last two simulated periods may differ at the end of a run
RELATIVE = 1e-4  # Accuracy to which harmonics without simulation agree with those of a run


def runs_with(evidence: Evidence, gap: float) -> list[DrivenRun]:
    """Return the runs with a gap (m; 0 without play) and the three forces of friction."""
    return [evidence.motion.driven.run(gap, force) for force in FORCES]


def micrometres(runs: Sequence[DrivenRun], order: int) -> list[float]:
    """Return the amplitude of a harmonic in each run, µm."""
    return [1e6 * run.harmonics[order] for run in runs]


def listed(values: Sequence[float]) -> str:
    """Return numbers, rounded to integers, in a row."""
    return ", ".join(f"{value:.0f}" for value in values)


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
    return so(f"{BY_LISTING}, {len(runs)} runs", tuple(run.repeat < SETTLED for run in runs))


def confirm_odd(evidence: Evidence) -> Confirmation:
    """Confirm by the simulated runs that the steady motion has odd harmonics only."""
    runs = evidence.motion.driven.runs
    return so(f"{BY_LISTING}, {len(runs)} runs", tuple(run.mirror < SETTLED for run in runs))


def confirm_friction(evidence: Evidence) -> Confirmation:
    """Confirm third and fifth harmonic of the run without play and with the least friction."""
    least, parameters = FORCES[0], evidence.numbers.parameters
    third, fifth = (harmonic_of_friction(parameters, least, order) for order in (3, 5))
    means = f"friction of {least} N as a square wave, its harmonics times the response to a force"
    return _both(means, third, fifth, evidence.motion.driven.run(0.0, least))


def confirm_play(evidence: Evidence, gap: float) -> Confirmation:
    """Confirm third and fifth harmonic of the run with a gap (m) and without friction."""
    system, play, drive = evidence.numbers.both_channels, FrictionBacklash(gap), MEASURED_DRIVE_OMEGA
    third, fifth = (harmonic_behind(system, play, DRIVE_AMPLITUDE, drive, order) for order in (3, 5))
    means = "the harmonics of backlash times the response to the pin, without friction"
    return _both(means, third, fifth, evidence.motion.driven.run(gap, 0.0))


def _both(means: str, third: float, fifth: float, run: DrivenRun) -> Confirmation:
    return close(means, complex(third, fifth), complex(run.harmonics[3], run.harmonics[5]), RELATIVE)


def period_in_words(evidence: Evidence) -> str:
    """Return how the runs agree with the theorem."""
    driven = evidence.motion.driven
    gap = 1e3 * max(run.gap for run in driven.runs)
    return one_line(f"""
        two motions with the same pin lose the energy of their difference to dampers and friction, so all end
        with the same velocities, which have the pin's period; in {len(driven.runs)} runs with gaps up to
        {gap:.0f} mm the last two periods differ by {power_of(max(run.repeat for run in driven.runs))} of the
        output at most, and two starts {1e3 * STARTED_ASIDE:.0f} mm apart have lost all but
        {power_of(driven.apart[-1])} of that energy after {driven.times[-1]:.1f} s
    """)
