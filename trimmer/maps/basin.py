"""Basins: from which initial values which motion is reached, on a slice over one initial value or two."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.arguments import require_instance
from trimmer.errors import MapError
from trimmer.maps.cell_motion import CellMotion, described, same_motion, stands_for_its_kind, waited_for
from trimmer.maps.inputs import MapInputs
from trimmer.maps.motion_map import motion_map
from trimmer.maps.result import MotionMap, place_columns
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.messages import listed, near_match
from trimmer.response.flows import require_subject
from trimmer.response.periodic.pace import periods_of
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Column, Table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Integers
    from trimmer.loops.loops import Loop
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.motion.subject import Subject

START = "start"  # First name of the places of initial values


@dataclass(frozen=True, eq=False, repr=False)
class Basin(Tabular, Drawn):
    """Which motion is reached from where.

    ``plot`` draws which motion is reached from where, if it is over two initial values; the legend numbers
    the motions from 1.

    Attributes:
        result: The map over the initial values, with all that is measured.
        motions: The distinct motions, in the order in which they were met. Periodic ones are told apart by
            their exact orbits; mirror images are two. All chaotic ones count as one, and so do all of each
            other kind that does not repeat.
        number: Which of them is reached, (n2, n1).
    """

    result: MotionMap
    motions: tuple[CellMotion, ...]
    number: Integers

    @property
    def shares(self) -> tuple[float, ...]:
        """Share of the cells from which each motion is reached."""
        return tuple(float((self.number == each).mean()) for each in range(len(self.motions)))

    @property
    def names(self) -> tuple[str, ...]:
        """What each motion is, numbered from 1, as in the legend; one that stands for a kind says so."""
        inputs = self.result.inputs
        told = (waited_for(described(motion), _waited(inputs, motion)) for motion in self.motions)
        all_of_it = (" (all such)" if stands_for_its_kind(motion) else "" for motion in self.motions)
        each = zip(told, all_of_it, strict=True)
        return tuple(f"{number}: {name}{every}" for number, (name, every) in enumerate(each, start=1))

    def _told(self) -> str:
        shares = (f"{name}, {share:.0%}" for name, share in zip(self.names, self.shares, strict=True))
        return f"over {' and '.join(self.result.places)}; {'; '.join(shares)}"

    def _table(self) -> Table:
        of_motion = (
            Column("motion", "", lambda cell: int(self.number.flat[cell]) + 1),
            Column("kind", "", lambda cell: self.motions[self.number.flat[cell]].kind),
            Column("period_count", "", lambda cell: self.motions[self.number.flat[cell]].period_count),
        )
        columns = (*place_columns(self.result), *of_motion)
        return Table("Motion that is reached from each start", range(self.number.size), columns)


def basin(mechanism: Mechanism | Loop, values: Mapping[str, ArrayLike], **settings: Any) -> Basin:
    """Tell from which initial values which motion is reached.

    Args:
        mechanism: The mechanism or loop; its other initial values are those of its own start, or zero.
        values: Values by body and ``displacement``, m, or ``velocity``, m/s, such as ``motor.velocity`` or
            ``start.motor.velocity``, or by state of a loop, such as ``q1`` or ``start.q1``; one or two. The
            first runs along a row.
        settings: As for ``motion_map``.

    Returns:
        The basin.

    Raises:
        MapError: if a place is no initial value, and as ``motion_map`` does.
    """
    require_subject(mechanism)
    require_instance("values", values, Mapping, "a mapping of bodies' initial values to numbers")
    places = {_start_place(mechanism, place): each for place, each in values.items()}
    result = motion_map(mechanism, places, **settings)
    motions: list[CellMotion] = []
    numbers = []
    for cell in result.cells:
        motion = cell.motions[0]
        found = next((at for at, other in enumerate(motions) if same_motion(motion, other)), len(motions))
        if found == len(motions):
            motions.append(motion)
        numbers.append(found)
    return Basin(result, tuple(motions), np.array(numbers, dtype=np.int64).reshape(result.shape))


def _start_place(subject: Subject, place: str) -> str:
    require_instance("place", place, str, "a body's initial value, such as motor.displacement")
    names = parse_place(place)
    if names[0] == START:
        return place
    whole = place_text((START, *names))
    if whole not in subject.places and names[1:] not in (("displacement",), ("velocity",)):
        there = [each for each in subject.places if parse_place(each)[0] == START]
        given = listed(place_text(parse_place(each)[1:]) for each in there)
        raise MapError(f"{place} is no initial value; {near_match(whole, there) or f'there are {given}'}")
    return whole


def _waited(inputs: MapInputs, motion: CellMotion) -> str:
    return periods_of(inputs.subject, motion.periods) if inputs.driven else inputs.over
