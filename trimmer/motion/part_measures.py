"""What a part that touches, and one that rubs, does over a motion."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self


@dataclass(frozen=True)
class ContactMeasures:
    """What a play or a stop does.

    Attributes:
        impacts: Number of contacts made per drive period, the mean.
        impact_speeds: Relative speed just before each contact of the motion, m/s, in their order.
        largest_force: Largest modulus of its force, N; None where it has none, as behind a loop's backlash.
        share: Share of the time in contact.
        completed: Of a wall, infinite chatters per drive period that were completed.
    """

    impacts: float
    impact_speeds: tuple[float, ...]
    largest_force: float | None
    share: float
    completed: float

    @property
    def impact_speed(self) -> float:
        """The largest of the speeds, m/s; 0 without impact."""
        return max(self.impact_speeds, default=0.0)

    @classmethod
    def joined(cls, parts: Sequence[Self]) -> Self:
        """Return what it does over several motions of one length, one after the other."""
        forces = [each.largest_force for each in parts if each.largest_force is not None]
        return cls(
            _mean([each.impacts for each in parts]),
            tuple(speed for each in parts for speed in each.impact_speeds),
            max(forces, default=None),
            _mean([each.share for each in parts]),
            _mean([each.completed for each in parts]),
        )


@dataclass(frozen=True)
class FrictionMeasures:
    """What a dry friction does.

    Attributes:
        work: Lost to it per drive period, the mean, J; without its viscous part.
        power: Mean power lost to it, W: what wears it.
        stick: Share of the time in stick.
    """

    work: float
    power: float
    stick: float

    @classmethod
    def joined(cls, parts: Sequence[Self]) -> Self:
        """Return what it does over several motions of one length, one after the other."""
        return cls(*(_mean([getattr(each, name) for each in parts]) for name in ("work", "power", "stick")))


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)
