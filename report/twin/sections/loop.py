"""The limit cycles of the thesis's loop over friction and gap."""

import numpy as np

from report.judging.parts import close, equal, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import LARGE_GAP, LARGER_GAP, SMALL_GAP
from report.numbers.twin.closed_loop import FORCES
from report.numbers.twin.kept_branch import KeptBranch
from report.numbers.twin.loop_numbers import BESIDE
from report.twin.figures.loop import loop_branches
from report.twin.observation import Observed, SectionRecord, observation
from trimmer.arrays import Reals

NUMBERS = "report/numbers/twin/loop_numbers.py"
MICRO = 1e6
KEPT = 1e-8  # Accuracy of what is kept
RETURNS = 1e-7  # Share of the largest state by which a kept orbit may miss its start after a period
ON_IT, AT_REST = 2.0, 1e-9
"""Half of peak to peak, in gaps: at least so much on the limit cycle, at most so much at rest."""
MOST = 0.9  # Share of the largest friction up to which harmonic balance is held against the orbits one by one


@observation("twin-loop-force", source=NUMBERS, title="More friction.")
def over_force(known: Evidence) -> Observed:
    loop, branch = known.twin.loop, known.twin.loop.over_force
    amplitude = MICRO * LARGE_GAP * loop.largest.amplitude
    yield text(f"""
        The thesis predicts limit cycles of a loop that nothing drives: its output moves the pin, and the
        bridge stays where it was left. With 40 µm of play and friction between cutter and guard this loop has
        two of them. More friction makes the stable one smaller and the unstable one larger, until they meet
        in a fold at {loop.largest_force:.4f} N, with an amplitude of {amplitude:.1f} µm at
        {loop.largest.frequency:.1f} Hz. With {BESIDE:.0%} more friction than that a motion of this size comes
        to rest; with {BESIDE:.0%} less it goes on.
    """)
    trends = [np.unique(np.sign(_changes(branch, chosen))) for chosen in (branch.stable, ~branch.stable)]
    yield so(
        "amplitudes of all orbits that were followed", [each.tolist() for each in trends] == [[-1.0], [1.0]]
    )
    yield close(
        "the largest friction by linear equations from one turn of the pin to the next, with SciPy's matrix "
        "exponential",
        loop.largest_force / LARGE_GAP,
        loop.largest.force_per_gap,
        KEPT,
    )
    yield so(
        "half a second simulated from a stable orbit near the fold",
        (loop.left_below > ON_IT, loop.left_above < AT_REST),
    )
    yield small("kept orbits, simulated, return to their start after a period", loop.miss, RETURNS)


def _changes(branch: KeptBranch, chosen: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> Reals:
    """Return the changes of the stroke from orbit to orbit as the number that is varied rises, m."""
    return np.asarray(np.diff(branch.strokes[chosen][np.argsort(branch.values[chosen])]))


@observation("twin-loop-gap", source=NUMBERS, title="A larger gap.")
def over_gap(known: Evidence) -> Observed:
    loop = known.twin.loop
    folds = [fold for each in loop.over_gap for fold in each.special_of("fold")]
    per_gap = loop.largest.force_per_gap
    yield text(f"""
        Amplitude over gap depends on friction over gap alone, so over the gap the same curve comes again:
        with {FORCES[0]}, {FORCES[1]} and {FORCES[2]} N the limit cycles begin at {MICRO * folds[0]:.1f},
        {MICRO * folds[1]:.1f} and {MICRO * folds[2]:.1f} µm, and the larger the gap, the nearer they are to
        those without friction. At the 4 µm of figure 5.23, with 0.6 N, the branch has none; the 2 mm of
        figure 5.21, with 0.15 N, are more than a hundred times the gap at the fold.
    """)
    ratios = [force / fold / per_gap for force, fold in zip(FORCES, folds, strict=True)]
    yield small("friction over gap is the same at all folds", max(abs(each - 1) for each in ratios), KEPT)
    without = known.orbits.friction
    yield so(
        "amplitude over gap, of all orbits that were followed",
        tuple(_nears(each, without.stable.amplitude, without.unstable.amplitude) for each in loop.over_gap),
    )
    yield so("gaps of both figures beside the folds", (folds[-1] > SMALL_GAP, 100 * folds[0] < LARGER_GAP))


def _nears(branch: KeptBranch, stable: float, unstable: float) -> bool:
    """Say whether amplitudes over a growing gap near those without friction, each in gaps."""
    limits = np.where(branch.stable, stable, unstable)
    away = abs(branch.strokes / 2 / branch.values - limits)
    found = (away[chosen][np.argsort(branch.values[chosen])] for chosen in (branch.stable, ~branch.stable))
    return all((np.diff(each) < 0).all() for each in found)


@observation("twin-loop-balance", source=NUMBERS, title="Harmonic balance.")
def balance(known: Evidence) -> Observed:
    loop, predicted = known.twin.loop, known.cycles.equivalent.in_place
    fold = LARGE_GAP * predicted.merger.force_per_gap
    amplitude, frequency = _errors(known)
    yield text(f"""
        Harmonic balance with play and friction each in its place, as in [figure 5.24b](#fig-5.24), puts the
        fold at {fold:.4f} N, {fold / loop.largest_force - 1:.2%} too high. Up to nine tenths of that friction
        its amplitudes are within {amplitude:.1%} and its frequencies within {frequency:.1%} of the exact
        ones. Besides the fold no special point was found: unlike in the driven trimmer no torus branches off,
        no period doubles, and cutter and guard never stick. A period has two impacts, two separations and two
        turns of the friction.
    """)
    yield so("the fold of the exact orbits lies below", loop.largest_force < fold)
    yield equal(
        "kinds of special points between all neighbouring orbits that were followed",
        {special.kind for each in loop.all for special in each.special},
        {"fold"},
    )
    yield equal("branches that part from them", {each.parted for each in loop.all}, {""})
    yield equal(
        "events in a period of simulated orbits",
        loop.events,
        {(("impact", 2), ("separation", 2), ("switch", 2))},
    )
    driven = {special.kind for each in known.twin.branches for special in each.special}
    yield so("kinds of special points of the driven trimmer", {"torus", "period-doubling"} <= driven)


def _errors(known: Evidence) -> tuple[float, float]:
    """Return the largest relative errors of harmonic balance in amplitude and in frequency, for 40 µm."""
    branch, predicted = known.twin.loop.over_force, known.cycles.equivalent.in_place
    amplitude = branch.strokes / 2 / LARGE_GAP
    frequency = 1 / (branch.periods * branch.states[:, -1])
    load = branch.values / LARGE_GAP
    errors = []
    for side, chosen in ((predicted.stable, branch.stable), (predicted.unstable, ~branch.stable)):
        at = chosen & (load <= MOST * predicted.merger.force_per_gap)
        for found, exact in ((side.amplitude, amplitude), (side.frequency, frequency)):
            by_balance = np.interp(load[at], side.force_per_gap, found)
            errors.append(float(abs(by_balance / exact[at] - 1).max()))
    return max(errors[::2]), max(errors[1::2])


SECTION = SectionRecord(
    "twin-loop", "The thesis's loop over friction and gap", (over_force, loop_branches, over_gap, balance)
)
