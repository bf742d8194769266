"""Claims of chapter 7 on Coulomb friction, and on where its effect was shown."""

import numpy as np

from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.judging.parts import assertion, so
from report.judging.record import Record, claim, text
from report.numbers.equivalent_nonlinearity import FORCES
from report.numbers.evidence import Evidence
from report.numbers.proven import cycle_is_proven
from report.numbers.thesis import EXPERIMENT_GAP, LARGE_GAP
from report.numbers.twin.kept_branch import KeptBranch
from trimmer.arrays import Reals

PROVEN, NONE_AT = 1.6, 1.65
"""Frictions in the experiment's gap, N: with one a limit cycle is proven, with the other none is found."""
BRANCH_METHOD = "all solutions of harmonic balance over the whole range of forces"


@claim("txt-7-coulomb")
def coulomb_friction(known: Evidence) -> Record:
    numbers, runs = known.cycles.equivalent, known.motion.released.by_force
    branch, both = numbers.in_place, numbers.in_place_both_channels
    merger, stable = branch.merger, branch.stable
    becomes_smaller = tuple(np.diff([run.amplitude for run in runs if run.goes_on]) < 0)
    yield assertion(
        "amplitude",
        "friction between cutter and guard makes the limit cycle smaller",
        tuple(np.diff(stable.amplitude) < 0),
        f"""
        from {stable.amplitude[0]:.3f} gaps without friction to {merger.amplitude:.3f} gaps at $F_c/b$ =
        {merger.force_per_gap:.0f} N/m
        """,
        method=BRANCH_METHOD,
        second=so("exact simulation of both channels", becomes_smaller),
    )
    *_, before, last = runs
    lasting = f"which lasts with {before.force} N and not with {last.force}"
    force, with_both = (EXPERIMENT_GAP * each.merger.force_per_gap for each in (branch, both))
    between = (before.goes_on, not last.goes_on, before.force < with_both < last.force)
    share = merger.force_per_gap / known.numbers.parameters.k2
    yield assertion(
        "existence",
        "enough friction ends it",
        tuple(rise for each in (stable, branch.unstable) for rise in np.diff(each.force_per_gap) > 0),
        f"at $F_c$ = {share:.4f} $k_2 b$ it meets the unstable one, and beyond there is none",
        method=BRANCH_METHOD,
        second=so(f"exact simulation of both channels, {lasting}", between),
    )
    exact = known.twin.loop.over_force
    period = np.interp(PROVEN * LARGE_GAP / EXPERIMENT_GAP, *periods_of_stable(exact))
    proven = cycle_is_proven("thesis-friction-orbit", PROVEN, EXPERIMENT_GAP, 1 / period, NONE_AT)
    yield text(f"""
        With friction in its place, between cutter and guard, and with its right sign the conclusion holds. It
        takes {merger.force_per_gap:.0f} N per metre of gap to end the limit cycle, {force:.2f} N for
        {1e6 * EXPERIMENT_GAP:.0f} µm; with the pin's velocity too, {both.merger.force_per_gap:.0f} N/m and
        {with_both:.2f} N. {proven}
        By Listing A.6, on which section 5.2.5 rests, the amplitude would grow with the force instead, to
        {1e3 * numbers.by_force[-1].amplitude:.0f} mm at {FORCES[-1]} N. The rest position
        stays stable, as the text has it: the more friction, the larger a disturbance it survives, and beyond
        that force any.
    """)


def periods_of_stable(branch: KeptBranch) -> tuple[Reals, Reals]:
    """Return the frictions of stable limit cycles, N, rising, and their periods, s."""
    values, periods = branch.values[branch.stable], branch.states[branch.stable, -1]
    order = np.argsort(values)
    return values[order], periods[order]


@claim("txt-7-coulomb-evidence")
def where_it_was_shown(known: Evidence) -> Record:
    yield assertion(
        "the experiment",
        "it can show a limit cycle that friction suppresses",
        not driven.has_the_drives_period(known),
        driven.period_in_words(known),
        method=driven.METHOD,
        second=driven.confirm_period(known),
    )
    yield text("""
        The answer names the findings of the experiment in section 3.3. The experiment is in section 3.2: its
        motor drives it, so that in the thesis's model it has no limit cycle with any friction and cannot show
        one being suppressed. If the simulations of section 3.3 are meant, their peak reads as a natural mode
        that dies out, see [the peak near 350 Hz](#txt-3.3-peak-350).

        That friction is wanted [stands by calculation](#txt-7-coulomb), not by measurement. To measure it
        takes a loop in which the output moves the pin.
    """)
