"""Which numbers of a mechanism its maps, branches and margins are over, and how far."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum

import numpy as np

from trimmer.arrays import Reals
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.analysis.plausible import largest_stroke
from trimmer.design.specification.targets import followers
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import place_text

STEPS = 6  # Cells of a map from zero to the number of the file, of 24
SPEEDS = (0.5, 1.5)  # Range of the speed, as shares of that of the file
SLACK = 0.2  # Range of a gap that is zero in the file, as a share of the largest stroke


class NumberRole(Enum):
    """What a number that is varied is: a gap, a gain, a speed, a friction, or another one."""

    GAP = "gap"
    GAIN = "gain"
    SPEED = "speed"
    FRICTION = "friction"
    OTHER = "number"


@dataclass(frozen=True)
class VariedNumber:
    """A number that maps and branches are over, with its range.

    Attributes:
        role: What it is.
        place: Its dotted place.
        part: The play, stop or friction; empty for the speed.
        unit: SI unit.
        value: The number of the file.
        lowest, highest: The range.
        bounded: Whether a bound of its own cuts the range, as the static force does that of the kinetic one.
    """

    role: NumberRole
    place: str
    part: str
    unit: str
    value: float
    lowest: float
    highest: float
    bounded: bool = False

    def values(self, cells: int) -> Reals:
        """Return the values of a map's side: evenly spaced, with that of the file among them if they can be.

        Args:
            cells: A multiple of 24, or fewer for a coarse map.
        """
        if self.role is NumberRole.SPEED:
            first, last = 0, cells - 1
        else:
            first, last = 1, cells
        step = (self.highest - self.lowest) / cells
        values: Reals = self.lowest + step * np.arange(first, last + 1, dtype=np.float64)
        return values


def varied_places(mechanism: Mechanism, motion: FoundMotion | None) -> tuple[VariedNumber, ...]:
    """Return gap, gain, speed and friction, as far as the mechanism has them.

    The gain is the first one that is not 0 of the first controller that follows a step. Of several plays and
    stops it is the one that is met fastest, of several frictions the one that turns most into heat; without a
    motion the first.
    """
    others = (*_speed(mechanism), *_friction(mechanism, motion))
    gains = [*_gains(mechanism)]
    gap = [*_gap(mechanism, motion)]
    return (*gap, *gains[:1], *others, *gains[1:2]) if gap or others else (*gains[:2],)


def _gap(mechanism: Mechanism, motion: FoundMotion | None) -> Iterator[VariedNumber]:
    parts = {**{name: ("plays", play) for name, play in mechanism.plays.items()},
             **{name: ("stops", stop) for name, stop in mechanism.stops.items()}}  # fmt: skip
    live = [name for name, (_, part) in parts.items() if part.stiffness or part.damping]
    if not live:
        return
    name = max(live, key=lambda each: _told_apart(motion.contacts[each].impact_speed) if motion else 0.0)
    section, part = parts[name]
    unit = mechanism.kind_of(section, name).unit("m")
    stroke = 0.0
    if motion is not None:
        stroke = largest_stroke(mechanism, motion, mechanism.kind_of(section, name))
    reach = abs(part.gap) or SLACK * stroke
    if not reach:
        return
    lowest, highest = (part.gap - reach, part.gap + 3 * reach) if part.gap else (0.0, reach)
    if section == "plays":
        lowest = max(lowest, 0.0)
    yield VariedNumber(
        NumberRole.GAP, place_text((section, name, "gap")), name, unit, part.gap, lowest, highest
    )


GAINS = ("kp", "kv", "ki", "kd")


def _gains(mechanism: Mechanism) -> Iterator[VariedNumber]:
    """Yield the gains of the first controller that follows a step, from next to nothing to twice as large."""
    for name in followers(mechanism)[:1]:
        for key in GAINS:
            value = getattr(mechanism.controllers[name], key, 0.0)
            if value > 0:
                place = place_text(("controllers", name, key))
                unit = mechanism.places[place]
                yield VariedNumber(NumberRole.GAIN, place, name, unit, value, 0.0, 2 * value)


def _told_apart(value: float) -> float:
    """Return a value to one part in a million, so that rounding does not choose between twins."""
    return float(f"{value:.6g}")


def _speed(mechanism: Mechanism) -> Iterator[VariedNumber]:
    if mechanism.frequency is not None:
        low, high = (share * mechanism.frequency for share in SPEEDS)
        yield VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", mechanism.frequency, low, high)
        return
    for name, pin in mechanism.pins.items():
        if pin.velocity:
            place = place_text(("pins", name, "velocity"))
            low, high = sorted((0.0, 2 * pin.velocity))
            yield VariedNumber(
                NumberRole.SPEED, place, name, mechanism.places[place], pin.velocity, low, high
            )
            return


def _friction(mechanism: Mechanism, motion: FoundMotion | None) -> Iterator[VariedNumber]:
    live = [name for name, friction in mechanism.frictions.items() if friction.kinetic_force > 0]
    if not live:
        return
    name = max(live, key=lambda each: _told_apart(motion.frictions[each].power) if motion else 0.0)
    friction = mechanism.frictions[name]
    kinetic = friction.kinetic_force
    place = place_text(("frictions", name, *(("curve", "1") if friction.curve else ()), "force"))
    if friction.static_force > kinetic:
        highest, bounded = friction.static_force, True
    elif friction.static is not None:
        highest, bounded = kinetic, True
    else:
        highest, bounded = 4 * kinetic, False
    unit = mechanism.kind_of("frictions", name).unit("N")
    yield VariedNumber(NumberRole.FRICTION, place, name, unit, kinetic, 0.0, highest, bounded)
