"""The parts of what moves, by the phases of their motion that begin and end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from trimmer.choices import Choice
from trimmer.kept_property import cached_property


class Phase(Choice):
    """A phase of the motion of a part that can begin and end."""

    UPPER = "contact on the upper side"
    LOWER = "contact on the lower side"
    EITHER = "contact on either side"
    ABOVE = "above the upper threshold"
    BELOW = "below the lower threshold"
    BEYOND = "beyond either threshold"
    STICK = "stick"


# What a phase is called where the sides are not told apart.
EITHER_SIDE: Mapping[Phase, Phase] = {
    Phase.UPPER: Phase.EITHER,
    Phase.LOWER: Phase.EITHER,
    Phase.ABOVE: Phase.BEYOND,
    Phase.BELOW: Phase.BEYOND,
}
TOUCHING = (Phase.UPPER, Phase.LOWER, Phase.EITHER)  # Phases of contact


@dataclass(frozen=True, eq=False)
class Part:
    """A part whose status is a part of a mode."""

    name: str  # Its name
    # The phase that each status belongs to; others belong to none that counts
    phases: Mapping[int, Phase] = field(default_factory=dict)
    # Status in the mirror image of a motion, of those for which it is another
    mirror: Mapping[int, int] = field(default_factory=dict)

    @cached_property
    def mirrored(self) -> Part:
        """The same part with its sides not told apart."""
        either = {status: EITHER_SIDE.get(phase, phase) for status, phase in self.phases.items()}
        return Part(self.name, either, self.mirror)

    def statuses(self, *phases: Phase) -> tuple[int, ...]:
        """Return the statuses of some phases, or of both sides of one."""
        return tuple(
            status
            for status, each in self.phases.items()
            if each in phases or EITHER_SIDE.get(each, each) in phases
        )

    @property
    def touches(self) -> bool:
        """Whether it has contact."""
        return any(phase in TOUCHING for phase in self.phases.values())

    @property
    def sticks(self) -> bool:
        """Whether it may be held."""
        return Phase.STICK in self.phases.values()


def mirrored(parts: tuple[Part, ...], statuses: tuple[int, ...]) -> tuple[int, ...]:
    """Return the statuses of all parts in the mirror image of a motion."""
    return tuple(part.mirror.get(status, status) for part, status in zip(parts, statuses, strict=True))
