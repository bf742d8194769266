"""The first screen: what holds and what does not, the five findings that matter most, and what to do."""

from __future__ import annotations

from report.document.extras import Highlight, Opening
from report.judging.text import filled
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
        _highlight(
            ("txt-5.2.1-open-loop-peak", "txt-3.1-output-sign"),
            """
            No trimmer feeds its output back, as the loop with the limit cycles does; with section 3.1's
            output even that loop has none.
            """,
            "Do not look for [[ frequency | f0 ]] Hz.",
            frequency=known.cycles.friction.stable.frequency,
        ),
        _highlight(
            ("twin-main",),
            """
            With contact both ways, 0.2 mm and 2 N repeat after [[ periods ]] drive periods: lines at thirds
            of the drive.
            """,
            "Look between the harmonics.",
            periods=known.twin.main.twin.period_count,
        ),
        _highlight(
            ("txt-3.3-open-loop-odd",),
            "Spectra measured with play have even harmonics; the model has none for any parameters.",
            "Compute without symmetry.",
        ),
        _highlight(
            ("txt-6.3-friction-dominates",),
            "By the thesis's own numbers friction does not dominate the cutter's inertia.",
            "Let it fly in the gap.",
        ),
        _highlight(
            ("txt-7-coulomb-evidence",),
            "Friction below [[ bound | f0 ]] N does not end the predicted cycle at 0.2 mm.",
            "That loop takes [[ force | f1 ]] N.",
            bound=BOUND,
            force=in_place,
        ),
    )


def _highlight(places: tuple[str, ...], sentence: str, action: str, /, **numbers: object) -> Highlight:
    said = {name: value for name, value in numbers.items() if f"[[ {name} " in sentence}
    done = {name: value for name, value in numbers.items() if name not in said}
    return Highlight(places, filled(sentence, **said), filled(action, **done))


def _do(known: Evidence) -> tuple[str, ...]:
    stiffness = known.twin.stiffness
    borne = stiffness.reaches[stiffness.second <= SOFT * (1 + 1e-9)].min()
    return (
        filled(
            "Hold the gap below [[ reach | f2 ]] mm ([[ friction | f1 ]] N, [[ speed | f0 ]] Hz).",
            reach=1e3 * known.twin.friction.reach(SMALL_FORCE),
            friction=SMALL_FORCE,
            speed=FREQUENCY,
        ),
        filled(
            "Soften the bridge: [[ soft | f0 ]] kN/m bears [[ borne | f1 ]] mm.",
            soft=1e-3 * SOFT,
            borne=1e3 * float(borne),
        ),
    )


def _do_not(known: Evidence) -> tuple[str, ...]:
    speed = known.twin.speed
    return (
        filled(
            "Fight 0.2 mm of play with friction: even [[ force | f1 ]] N hold from rest only.",
            force=known.twin.friction_for_experiment,
        ),
        filled(
            """
            Trust one speed: [[ slower | f0 ]] Hz bears [[ less | f2 ]] mm, [[ speed | f0 ]] Hz
            [[ more | f2 ]] mm.
            """,
            slower=SLOWER,
            less=1e3 * speed.reach(SLOWER),
            speed=FREQUENCY,
            more=1e3 * speed.reach(FREQUENCY),
        ),
    )
