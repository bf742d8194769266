"""Where the phases of the motion change along a branch: grazing, and the birth and death of stick."""

from collections.abc import Sequence
from dataclasses import dataclass

from trimmer.branches.arc import Arc
from trimmer.branches.branch import BranchPoint
from trimmer.branches.narrowing import narrowed
from trimmer.branches.orbit import Place
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.motion.part import Phase

MOST_BORDERS = 12  # Changes of phases on one step, beyond which the step is shortened
CONTINUOUS = 1e-9  # Distance of the orbits on both sides of a border, beyond which the branch is torn
IMPACT = 1e3  # Largest multiplier beyond which it is that of an impact almost without speed
DISTINCT = 1.5
"""Ratio of the speeds of two impacts, beyond which a line through them tells well where there is none."""


@dataclass(frozen=True, eq=False)
class Border:
    """Two neighbouring orbits with different phases."""

    before: Place  # The one that comes first on the branch
    after: Place  # The other

    @property
    def changes(self) -> dict[tuple[str, Phase], int]:
        """By how much the number of phases changes that begin, by part and kind; only what changes."""
        before, after = dict(self.before.signature), dict(self.after.signature)
        changes = {key: after.get(key, 0) - before.get(key, 0) for key in {*before, *after}}
        return {key: change for key, change in changes.items() if change}

    @property
    def is_single(self) -> bool:
        """Whether a single phase is born or dies."""
        return [abs(change) for change in self.changes.values()] == [1]


def borders(arc: Arc, near: Place, far: Place) -> list[Border] | None:
    """Find the changes of phases between two orbits of an arc, in their order.

    What changes at one value is one border: with two like sides rounding tells there in which order.

    Returns:
        The borders; None if orbits between are not found, jump, or change their phases too often.
    """
    found: list[Border] = []
    left = near
    for _ in range(MOST_BORDERS):
        if left.signature == far.signature:
            return [border for border in found if border.changes]
        nearest = narrowed(arc, left, far)
        if nearest is None or _apart(*nearest) > CONTINUOUS:
            return None
        before = found.pop().before if found and _apart(left, nearest[0]) <= CONTINUOUS else nearest[0]
        found.append(Border(before, nearest[1]))
        left = nearest[1]
    return [border for border in found if border.changes] if left.signature == far.signature else None


def _apart(one: Place, other: Place) -> float:
    return float(abs(one.position - other.position).max())


def special_points(border: Border) -> list[SpecialPoint]:
    """Return what a border is: a grazing, an onset of stick, or several of these at once."""
    changed, found = border.changes, []
    for kind in (SpecialKind.GRAZING, SpecialKind.STICK):
        sticks = kind is SpecialKind.STICK
        of_kind = {key: change for key, change in changed.items() if (key[1] is Phase.STICK) == sticks}
        if of_kind:
            found.append(_special_point(border, kind, of_kind))
    return found


def grazing(place: Place, points: Sequence[BranchPoint]) -> SpecialPoint:
    """Return where a branch touches rigid walls without speed as a special point.

    Behind it impacts are born, or die, and the map has a square root there: no orbit of the branch goes on.
    As the speed of an impact falls to zero, the largest multiplier grows as its inverse, and the branch is
    smooth in that speed; so the point is found beyond the last orbit, where the inverse multiplier is zero.

    Args:
        place: The last orbit that was found.
        points: The orbits up to it.
    """
    last = points[-1]
    growths = {
        _largest(last) / _largest(each): each
        for each in points[:-1]
        if each.signature == last.signature and _largest(each) > IMPACT
    }
    value, state = place.value, place.strobed
    growth = min((each for each in growths if each > DISTINCT), default=None)
    if growth is not None:
        before, beyond = growths[growth], 1.0 / (growth - 1.0)
        value += beyond * (last.value - before.value)
        state = last.state + beyond * (last.state - before.state)
    return SpecialPoint(SpecialKind.GRAZING, value, state, place.passage.grazed, "an impact without speed")


def _largest(point: BranchPoint) -> float:
    return float(abs(point.multipliers).max())


def _special_point(border: Border, kind: SpecialKind, changes: dict[tuple[str, Phase], int]) -> SpecialPoint:
    parts = tuple(sorted({part for part, _ in changes}))
    notes = [
        f"{part}: {phase.value}, {change:+d}{_pause(border, part, phase, change)}"
        for (part, phase), change in sorted(changes.items(), key=lambda item: (item[0][0], item[0][1].name))
    ]
    outside = [int((abs(place.multipliers) > 1.0).sum()) for place in (border.before, border.after)]
    if border.after.error > CONTINUOUS:
        notes.append("no orbit lies beyond")
    elif outside[0] != outside[1]:
        notes.append(f"multipliers outside the unit circle jump from {outside[0]} to {outside[1]}")
    return SpecialPoint(kind, border.before.value, border.before.strobed, parts, "; ".join(notes))


def _pause(border: Border, part: str, phase: Phase, change: int) -> str:
    """Return what is to be said where a pause in a phase is born or dies, and not a phase by itself."""
    passage = (border.after if change > 0 else border.before).passage
    if not passage.opens(part, phase):
        return ""
    return ", where it slips for a moment" if phase is Phase.STICK else ", where it lifts off for a moment"
