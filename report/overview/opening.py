"""The first screen: what holds and what does not, the five findings that matter most, and what to do."""

from report.document.extras import Highlight, Opening
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.advice import LINES
from report.overview.opening_figure import opening_figure

BOUND = 1.0  # Of friction in the thesis, N

SENTENCES = (
    "Computed again with a bridge that pushes back on the motor, a trimmer with play has "
    "harmonics of the drive, subharmonics and chaos."
)


def opening(known: Evidence) -> Opening:
    """Return the first screen; its template says before it how many printed things follow."""
    return Opening(
        sentences=SENTENCES, highlights=_highlights(known), figure=opening_figure(known), advice=LINES
    )


def _highlights(known: Evidence) -> tuple[Highlight, ...]:
    main = known.twin.main.twin
    in_place = known.cycles.equivalent.in_place.merger.force_per_gap * EXPERIMENT_GAP
    return (
        Highlight(
            ("txt-5.2.1-open-loop-peak",),
            "In a trimmer nothing feeds the output back to the pin, so it does not have the predicted limit "
            "cycles.",
            f"Expect no oscillation at {known.cycles.friction.stable.frequency:.0f} Hz.",
        ),
        Highlight(
            ("twin-main",),
            f"With 0.2 mm of play and 2 N of friction at {main.frequency:.0f} Hz the motion repeats only "
            f"after {main.period_count} drive periods.",
            "Look for peaks at thirds of the drive.",
        ),
        Highlight(
            ("txt-3.3-open-loop-odd",),
            "Spectra measured with play have even harmonics. The thesis's model cannot have them.",
            "Use a model whose motion need not be symmetric.",
        ),
        Highlight(
            ("txt-6.3-friction-dominates",),
            "By the thesis's own numbers friction does not dominate the cutter's inertia.",
            "Compute with a bridge that can leave the pin.",
        ),
        Highlight(
            ("txt-7-coulomb-evidence",),
            f"Friction below {BOUND:.0f} N does not end the predicted limit cycle at 0.2 mm of play.",
            f"In the loop it takes {in_place:.1f} N.",
        ),
    )
