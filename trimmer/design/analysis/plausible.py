"""Numbers that a small machine is unlikely to have; they are asked about, not refused."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto

from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.waves import reach_of

HEAVY = 50.0  # Mass of a body, as a multiple of the middle one of all, from which it is asked about
LONG = 0.05  # Displacement, m, from which it is asked about in a machine of the hand
HAND = 1.0  # Mass of all bodies together, kg, up to which a machine counts as one of the hand
DRIVES = 5.0, 2000.0  # Frequencies that such a machine is driven at, Hz
PENETRATION = 0.5
"""Depth of a contact, as a share of the largest stroke, from which its stiffness is asked about."""


class Oddity(Enum):
    """Why a number is unlikely."""

    HEAVY_BODY = auto()
    HEAVY_FOR_HAND = auto()
    LONG_STROKE = auto()
    GAP_ABOVE_STROKE = auto()
    SLOW_OR_FAST = auto()
    SOFT_CONTACT = auto()
    FRICTION_HOLDS = auto()


@dataclass(frozen=True)
class Question:
    """A number that is unlikely, and should be looked at again.

    Attributes:
        oddity: Why.
        place: Names that lead there.
        value: The number, SI unit.
        beside: What it is compared with, in the same unit.
    """

    oddity: Oddity
    place: tuple[str, ...]
    value: float
    beside: float

    @property
    def place_text(self) -> str:
        """The dotted place."""
        return place_text(self.place)


def questions(mechanism: Mechanism, motion: FoundMotion | None) -> tuple[Question, ...]:
    """Return what is asked about a mechanism.

    A mechanism without dimensions, such as a textbook's with a mass of 1 kg and a drive of 0.1 Hz, is asked
    about relations only, not about sizes.
    """
    found = [*_bodies(mechanism), *_gaps(mechanism)]
    if _is_of_hand(mechanism):
        found += _sizes(mechanism)
    if motion is not None:
        found += [*_contacts(mechanism, motion), *_held(mechanism, motion)]
    return tuple({each.place: each for each in reversed(found)}.values())[
        ::-1
    ]  # one of each place: the first


def _is_of_hand(mechanism: Mechanism) -> bool:
    masses = sorted(_masses(mechanism).values())
    return bool(masses) and masses[(len(masses) - 1) // 2] < HAND


def _masses(mechanism: Mechanism) -> dict[str, float]:
    """Return the masses of what does not turn, kg."""
    return {name: body.mass for name, body in mechanism.bodies.items() if body.mass is not None}


def _bodies(mechanism: Mechanism) -> Iterator[Question]:
    masses = _masses(mechanism)
    if len(masses) < 3:
        return
    middle = sorted(masses.values())[len(masses) // 2]
    for name, mass in masses.items():
        if mass >= HEAVY * middle or mass * HEAVY <= middle:
            yield Question(Oddity.HEAVY_BODY, ("bodies", name, "mass"), mass, middle)


def _sizes(mechanism: Mechanism) -> Iterator[Question]:
    for name, mass in _masses(mechanism).items():
        if mass > HAND:
            yield Question(Oddity.HEAVY_FOR_HAND, ("bodies", name, "mass"), mass, HAND)
    for name, pin in mechanism.pins.items():
        if mechanism.kinds[name] is Kind.TRANSLATION and abs(pin.amplitude) > LONG / 2:
            yield Question(Oddity.LONG_STROKE, ("pins", name, "amplitude"), pin.amplitude, LONG / 2)
    if mechanism.frequency is not None and not DRIVES[0] <= mechanism.frequency <= DRIVES[1]:
        near = DRIVES[0] if mechanism.frequency < DRIVES[0] else DRIVES[1]
        yield Question(Oddity.SLOW_OR_FAST, ("frequency",), mechanism.frequency, near)


def _gaps(mechanism: Mechanism) -> Iterator[Question]:
    for name, play in mechanism.plays.items():
        kind = mechanism.kind_of("plays", name)
        alike = [pin for each, pin in mechanism.pins.items() if mechanism.kinds[each] is kind]
        stroke = 2 * max((reach_of(pin) for pin in alike), default=0.0)
        if 0 < stroke <= play.gap:
            yield Question(Oddity.GAP_ABOVE_STROKE, ("plays", name, "gap"), play.gap, stroke)


def _contacts(mechanism: Mechanism, motion: FoundMotion) -> Iterator[Question]:
    for section in ("plays", "stops"):
        for name, part in getattr(mechanism, section).items():
            stroke = largest_stroke(mechanism, motion, mechanism.kind_of(section, name))
            found = motion.contacts.get(name)
            if found is None or part.stiffness == 0:
                continue
            depth = found.largest_force / part.stiffness
            if depth > PENETRATION * stroke > 0:
                yield Question(Oddity.SOFT_CONTACT, (section, name, "stiffness"), depth, stroke)


def largest_stroke(mechanism: Mechanism, motion: FoundMotion, kind: Kind) -> float:
    """Return the largest peak to peak of the outputs of a kind, m or rad."""
    units = mechanism.output_units
    unit = kind.unit("m")
    alike = (each for name, each in motion.outputs.items() if units.get(name, "m") == unit)
    return max((each.peak_to_peak for each in alike), default=0.0)


def _held(mechanism: Mechanism, motion: FoundMotion) -> Iterator[Question]:
    for name, measures in motion.frictions.items():
        if measures.stick >= 1 - 1e-9:
            part = mechanism.frictions[name]
            place = ("frictions", name, *(("curve", "1") if part.curve else ()), "force")
            yield Question(Oddity.FRICTION_HOLDS, place, part.kinetic_force, part.kinetic_force)
