"""A branch over the gap with its bifurcations."""

from report.judging.parts import close, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.twin.grids import BRANCH_FORCE, COURSES
from report.numbers.twin.kept_branch import KeptBranch
from report.twin.figures.maps import branches_over_gap
from report.twin.observation import Observed, SectionRecord, observation

BRANCH = "report/numbers/twin/kept_branch.py"
AGAIN = 1e-6
MICRO = 1e6


def trunk(known: Evidence) -> KeptBranch:
    """Return the branch of the drive's period."""
    named = (COURSES[0].name, "")
    return next(each for each in known.twin.branches if (each.course.name, each.parted) == named)


def island(known: Evidence) -> KeptBranch:
    """Return the branch of three drive periods."""
    named = (COURSES[1].name, "")
    return next(each for each in known.twin.branches if (each.course.name, each.parted) == named)


@observation("twin-trunk", source=BRANCH, title="The drive's period.")
def drive_period(known: Evidence) -> Observed:
    branch = trunk(known)
    (_, first_end), second, *_ = branch.stable_pieces
    torus, back, lost = branch.special_of("torus")[:3]
    breaking = branch.special_of("symmetry-breaking")
    row = known.twin.friction.row(BRANCH_FORCE)
    values, single = known.twin.friction.first, known.twin.friction.single[row]
    yield text(f"""
        With 2 N at 110 Hz the motion of the drive's period loses its stability at a gap of
        {MICRO * torus:.2f} µm, where a torus is born. It is stable again between {MICRO * back:.2f} and
        {MICRO * lost:.2f} µm. Its symmetry breaks at {MICRO * breaking[0]:.2f}, {MICRO * breaking[1]:.2f} and
        {MICRO * breaking[2]:.2f} µm, where pairs of mirrored motions part from it. Beyond {MICRO * lost:.0f}
        µm it goes on, unstable except for short pieces, which a motion from rest does not reach.
    """)
    yield so("multipliers of the exact orbits on both sides", first_end < torus < back <= second[0] < lost)
    yield so(
        "the map from rest keeps the drive's period up to the last gap of its grid below the torus, and "
        "leaves it at the next but one at most",
        [single[each].all() for each in (values < torus - 5e-6, (values > torus) & (values < 1.3e-4))]
        == [True, False],
    )
    yield small(
        "orbits solved again from their kept states keep their stroke", known.twin.branches_again, AGAIN
    )


@observation("twin-island", source=BRANCH, title="Three drive periods.")
def three_periods(known: Evidence) -> Observed:
    branch = island(known)
    folds, doublings = branch.special_of("fold"), branch.special_of("period-doubling")
    longest = max(branch.stable_pieces, key=lambda piece: abs(piece[1] - piece[0]))
    yield text(f"""
        The motions of three drive periods form a closed branch of their own, from a fold at
        {MICRO * min(folds):.2f} µm to a fold at {MICRO * max(folds):.2f} µm: no small change leads to them
        from the drive's period. Its longest stable piece reaches from {MICRO * min(longest):.1f} to
        {MICRO * max(longest):.1f} µm. At 0.2 mm the motion from rest is on it; at {MICRO * doublings[0]:.2f}
        µm its period doubles to six drive periods and at {MICRO * doublings[1]:.2f} µm it halves again.
    """)
    yield so("the branch closes on itself", branch.message.startswith("it closes on itself"))
    yield so(
        "its orbits lie between the two folds",
        (min(folds) - 1e-9 <= float(branch.values.min()), float(branch.values.max()) <= max(folds) + 1e-9),
    )
    yield close(
        "its stroke at 0.2 mm is that of the motion from rest",
        float(branch.strokes[0]),
        known.twin.main.twin.peak_to_peak,
        AGAIN,
    )


SECTION = SectionRecord(
    "twin-branch", "A branch and its bifurcations", (drive_period, branches_over_gap, three_periods)
)
