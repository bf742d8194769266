"""The first screen: what holds and what does not, the five findings that matter most, and what to do."""

from __future__ import annotations

from report.document.extras import Highlight, Opening
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.mechanism import FREQUENCY, SMALL_FORCE
from report.overview.opening_figure import opening_figure

BOUND = 1.0
"""Of friction in the thesis, N."""
SLOWER = 108.0
"""A speed beside that of the trimmer, Hz."""
SOFT = 10e3
"""Stiffness of a bridge that bears every gap of the map, N/m."""

SENTENCES = (
    "The predictions do not carry over: no trimmer has their loop. So the trimmer with contact both ways was "
    "computed."
)


def opening(known: Evidence) -> Opening:
    """Return the first screen; its template says before it how many printed things follow."""
    return Opening(
        sentences=SENTENCES,
        highlights=_highlights(known),
        figure=opening_figure(known),
        do=_do(known),
        do_not=_do_not(known),
    )


def _highlights(known: Evidence) -> tuple[Highlight, ...]:
    in_place = known.cycles.equivalent.in_place.merger.force_per_gap * EXPERIMENT_GAP
    return (
        Highlight(
            ("txt-5.2.1-open-loop-peak", "txt-3.1-output-sign"),
            "No trimmer feeds its output back, as the loop with the limit cycles does; with section 3.1's "
            "output even that loop has none.",
            f"Do not look for {known.cycles.friction.stable.frequency:.0f} Hz.",
        ),
        Highlight(
            ("twin-main",),
            f"With contact both ways, 0.2 mm and 2 N repeat after {known.twin.main.twin.period_count} drive "
            "periods: lines at thirds of the drive.",
            "Look between the harmonics.",
        ),
        Highlight(
            ("txt-3.3-open-loop-odd",),
            "Spectra measured with play have even harmonics; the model has none for any parameters.",
            "Compute without symmetry.",
        ),
        Highlight(
            ("txt-6.3-friction-dominates",),
            "By the thesis's own numbers friction does not dominate the cutter's inertia.",
            "Let it fly in the gap.",
        ),
        Highlight(
            ("txt-7-coulomb-evidence",),
            f"Friction below {BOUND:.0f} N does not end the predicted cycle at 0.2 mm.",
            f"That loop takes {in_place:.1f} N.",
        ),
    )


def _do(known: Evidence) -> tuple[str, ...]:
    stiffness = known.twin.stiffness
    borne = stiffness.reaches[stiffness.second <= SOFT * (1 + 1e-9)].min()
    reach = known.twin.friction.reach(SMALL_FORCE)
    return (
        f"Hold the gap below {1e3 * reach:.2f} mm ({SMALL_FORCE:.1f} N, {FREQUENCY:.0f} Hz).",
        f"Soften the bridge: {1e-3 * SOFT:.0f} kN/m bears {1e3 * float(borne):.1f} mm.",
    )


def _do_not(known: Evidence) -> tuple[str, ...]:
    slower, faster = (1e3 * known.twin.speed.reach(each) for each in (SLOWER, FREQUENCY))
    return (
        f"Fight 0.2 mm of play with friction: even {known.twin.friction_for_experiment:.1f} N hold from rest "
        "only.",
        f"Trust one speed: {SLOWER:.0f} Hz bears {slower:.2f} mm, {FREQUENCY:.0f} Hz {faster:.2f} mm.",
    )
