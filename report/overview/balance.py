"""What the thesis got right beside what it did not, by matter; each side with cards on which it rests."""

from __future__ import annotations

from report.document.extras import Matter
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP, SMALL_GAP


def balance(known: Evidence) -> tuple[Matter, ...]:
    """Return the matters in the order of the thesis, with the numbers as solved."""
    stable = known.cycles.friction.stable
    per_gap = known.cycles.equivalent.in_place.merger.force_per_gap
    error = abs(known.orbits.friction.stable.amplitude_error)
    in_place, small = per_gap * EXPERIMENT_GAP, per_gap * SMALL_GAP
    takes = known.twin.friction_for_experiment
    return (
        _matter(
            "The linear trimmer",
            "Equations of motion, state space and transfer function are right, and so are the eight "
            "eigenvalues: it is stable. One mode does not show in the response.",
            ("eq-2.9", "eq-5.2", "txt-5.1.2-order", "txt-5.1.3-hidden-peak"),
            "The response falls by 40 dB per decade, not by 20. Damping lowers the peaks. The resonances lie "
            "above the drive, where its harmonics meet them, not below.",
            ("txt-5.1.2-roll-off", "txt-7-damping", "txt-7-operating-frequency"),
        ),
        _matter(
            "Describing functions",
            "Those of play are right for a load that friction holds and for one that flies on, and so is "
            "that of dry friction.",
            ("eq-2.38", "eq-2.43", "eq-2.52", "txt-2.3.4-contact-angle"),
            "For a load with viscous friction one sign is wrong, and with it a listing and a figure. Where "
            "dry friction joins the play, it has the wrong sign: it would feed the oscillation.",
            ("eq-2.46", "txt-5.2.5-coulomb-term", "lst-A.6"),
        ),
        _matter(
            "Limit cycles of the loop",
            "There are two. The larger is stable, with an amplitude in proportion to the gap, at a frequency "
            f"of {stable.frequency:.0f} to {known.cycles.inertia.stable.frequency:.0f} Hz that depends on "
            f"the load. The describing function gives the amplitude of the larger to {error:.1%}.",
            (
                "txt-5.2.1-proportional",
                "fig-5.10",
                "txt-5.2.1-stable",
                "txt-5.2.3-band",
                "txt-5.2.3-unstable-inner",
            ),
            "There is no smallest gap: both exist for every gap. A driven trimmer has neither, since nothing "
            "feeds its output back to the pin.",
            ("txt-5.2.1-threshold", "txt-5.2.1-second-limit-cycle", "txt-5.2.1-open-loop-peak"),
        ),
        _matter(
            "Friction",
            "Enough dry friction between cutter and guard ends the limit cycles.",
            ("txt-7-coulomb", "txt-3.3-friction-suppresses"),
            f"That takes {in_place:.1f} N at 0.2 mm, more than the thesis assumes. The limit cycle printed "
            f"for 0.6 N and 4 µm, at 737.514 Hz, does not exist: for this gap friction ends it at "
            f"{small:.2g} N, and without friction it is at {stable.frequency:.1f} Hz. The real trimmer at "
            f"110 Hz has no limit cycle to end; with 0.2 mm it takes {takes:.1f} N to repeat with the drive. "
            "Friction does not dominate the cutter's inertia.",
            ("txt-5.2.5-prediction", "txt-7-coulomb-evidence", "txt-6.3-friction-dominates"),
        ),
        _matter(
            "The experiment",
            "Without play the spectrum has odd harmonics alone, as the model says. The peak at 550 Hz is the "
            "fifth harmonic near a natural mode.",
            ("txt-3.2-odd-harmonics", "txt-3.3-peak-550", "txt-3.1-resolution"),
            "With play it has even harmonics, which the model cannot have. The peaks read as limit cycles "
            "are harmonics or modes that die out.",
            ("txt-3.3-open-loop-odd", "txt-3.3-peak-366", "txt-3.3-peak-350"),
        ),
    )


def _matter(title: str, right: str, kept: tuple[str, ...], wrong: str, slips: tuple[str, ...]) -> Matter:
    return Matter(title, one_line(right), kept, one_line(wrong), slips)
