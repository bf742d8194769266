"""A mechanism: bodies, and what holds, pushes and rubs them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trimmer.arguments import file_path, require_instance
from trimmer.errors import MechanismError
from trimmer.mechanism import number_rows
from trimmer.mechanism.checks import problems_of_types
from trimmer.mechanism.controls import reading as control_reading
from trimmer.mechanism.controls.checks import SECTIONS
from trimmer.mechanism.controls.controllers import Controller
from trimmer.mechanism.controls.references import Reference
from trimmer.mechanism.kinds import Kind, kind_of_output, kind_of_part, kind_of_point, kinds_of
from trimmer.mechanism.outputs import UNITS, taken
from trimmer.mechanism.parts import (
    COUPLINGS,
    Body,
    ContactLaw,
    Force,
    Friction,
    Link,
    Output,
    Pin,
    Play,
    Point,
    Stop,
    Wall,
)
from trimmer.mechanism.problems import Problem, as_message
from trimmer.mechanism.quantities import DISPLACEMENT, FREQUENCY, PARTS, QUANTITIES, VELOCITY, WEIGHT
from trimmer.mechanism.read_only import ReadOnly
from trimmer.mechanism.sense import problems_of_numbers, problems_of_sense
from trimmer.mechanism.structures.structure import Structure
from trimmer.showing.shown import Shown, counted

if TYPE_CHECKING:
    import control

SINGULAR = {"bodies": "body"}
WEIGHTS = "_weights"  # Under which ``trimmer.mechanism.coordinates`` keeps the weights of ends


@dataclass(frozen=True, eq=False, repr=False)
class Mechanism(Shown):
    """Bodies that move along one line or turn, and what holds, pushes and rubs them, by name.

    Mappings are copied into read-only ones. Two mechanisms are equal if they have the same parts in the same
    order, because the order of the parts is that of the states.

    Attributes:
        bodies: Their order is the order of the displacements.
        frequency: That of the drive, Hz; None for a mechanism that moves by itself.
        drives: Frequencies of further drives, Hz.
        title: What it is.
        structures: Linear parts given by matrices or modes; their coordinates, such as ``housing.u1``, follow
            the bodies, and stand wherever a body may.
        start: Displacement, m, and velocity, m/s, of bodies at t = 0; the others are at rest at 0.
        points: Weighted sums of displacements, which stand wherever a body may.
        controllers: What measures an output and acts with a force.
        references: What controllers follow.

    Raises:
        MechanismError: if a part cannot be used or the parts do not go together; every problem is named.
    """

    bodies: Mapping[str, Body] = field(default_factory=dict)
    frequency: float | None = None
    pins: Mapping[str, Pin] = field(default_factory=dict)
    links: Mapping[str, Link] = field(default_factory=dict)
    plays: Mapping[str, Play] = field(default_factory=dict)
    stops: Mapping[str, Stop] = field(default_factory=dict)
    frictions: Mapping[str, Friction] = field(default_factory=dict)
    forces: Mapping[str, Force] = field(default_factory=dict)
    outputs: Mapping[str, Output] = field(default_factory=dict)
    start: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    title: str = ""
    points: Mapping[str, Point] = field(default_factory=dict)
    structures: Mapping[str, Structure] = field(default_factory=dict)
    walls: Mapping[str, Wall] = field(default_factory=dict)
    drives: Mapping[str, float] = field(default_factory=dict)
    controllers: Mapping[str, Controller] = field(default_factory=dict)
    references: Mapping[str, Reference] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if problems := problems_with(vars(self)):
            raise MechanismError(as_message(problems))
        for section in PARTS:
            parts = {name: _taken(part) for name, part in getattr(self, section).items()}
            object.__setattr__(self, section, ReadOnly(parts))
        outputs = {name: taken(output) for name, output in self.outputs.items()}
        points = {name: self._taken_point(point) for name, point in self.points.items()}
        start = {
            name: (DISPLACEMENT.taken(displacement), VELOCITY.taken(velocity))
            for name, (displacement, velocity) in self.start.items()
        }
        drives = {name: FREQUENCY.taken(each) for name, each in self.drives.items()}
        for section, controls in control_reading.taken(vars(self), self.kinds).items():
            object.__setattr__(self, section, controls)
        object.__setattr__(self, "drives", ReadOnly(drives))
        object.__setattr__(self, "outputs", ReadOnly(outputs))
        object.__setattr__(self, "points", ReadOnly(points))
        object.__setattr__(self, "start", ReadOnly(start))
        if self.frequency is not None:
            object.__setattr__(self, "frequency", FREQUENCY.taken(self.frequency))

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of what it moves by, in the order of all states: bodies, then coordinates of structures."""
        structures = self.structures.items()
        return (*self.bodies, *(f"{name}.{each}" for name, part in structures for each in part.names))

    def _taken_point(self, point: Point) -> Point:
        turning = any(self.kinds.get(name) is Kind.ROTATION for name in point.weights)
        weights = {name: WEIGHT.taken(weight) for name, weight in point.weights.items()}
        return Point(ReadOnly(weights), turning and kind_of_point(self.kinds, point) is Kind.TRANSLATION)

    @property
    def kinds(self) -> Mapping[str, Kind]:
        """Whether each body, point and pin is a translation or a rotation, by name."""
        if "_kinds" not in vars(self):
            object.__setattr__(self, "_kinds", ReadOnly(kinds_of(vars(self))))
        kinds: Mapping[str, Kind] = vars(self)["_kinds"]
        return kinds

    def kind_of(self, section: str, name: str) -> Kind:
        """Return the kind of a part or of an output, which its units follow: see ``Kind.unit``."""
        part = getattr(self, section)[name]
        if section == "outputs":
            return kind_of_output(vars(self), self.kinds, part)
        return kind_of_part(self.kinds, section, name, part)

    @property
    def output_units(self) -> Mapping[str, str]:
        """The SI unit of each output, by name."""
        return {
            name: self.kind_of("outputs", name).unit(UNITS[each.kind]) for name, each in self.outputs.items()
        }

    def _told(self) -> str:
        sections = ((name, len(getattr(self, name))) for name in (*PARTS, "points", *SECTIONS))
        parts = ", ".join(counted(count, SINGULAR.get(name, name[:-1])) for name, count in sections if count)
        return f"{self.title}, {parts}" if self.title else parts

    def __eq__(self, other: object) -> bool:
        return self._contents == other._contents if isinstance(other, Mechanism) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._contents)

    @property
    def _contents(self) -> tuple[object, ...]:
        values = (getattr(self, each.name) for each in fields(self))
        return tuple(tuple(value.items()) if isinstance(value, Mapping) else value for value in values)

    @classmethod
    def from_toml(cls, path: Path | str) -> Mechanism:
        """Read a mechanism from a TOML file, which ``docs/mechanism.md`` describes; ``-`` is standard input.

        Raises:
            MechanismError: if the file cannot be read or is no TOML or no mechanism. Every problem is named,
                with file, line, key and value, and what to do.
        """
        from trimmer.mechanism.reading import read_mechanism

        return read_mechanism(file_path("path", path))

    @classmethod
    def from_toml_text(cls, text: str, name: str = "the text", folder: Path | str = Path()) -> Mechanism:
        """Read a mechanism from the text of a TOML file.

        Args:
            text: The text.
            name: What messages call it.
            folder: Where the files are that it names; the working directory if not given.

        Raises:
            MechanismError: as for a file.
        """
        from trimmer.mechanism.reading import mechanism_of_text

        require_instance("text", text, str, "the text of a TOML file")
        return mechanism_of_text(text, name, folder=file_path("folder", folder))

    def to_toml(self) -> str:
        """Return the mechanism as the text of a TOML file, which reads back equal."""
        from trimmer.mechanism.writing import mechanism_as_toml

        return mechanism_as_toml(self)

    @property
    def places(self) -> Mapping[str, str]:
        """The SI unit of every number, by its dotted place, such as ``{"plays.bridge.gap": "m"}``."""
        from trimmer.mechanism.place_text import place_text
        from trimmer.mechanism.places import quantities

        return ReadOnly({place_text(place): each.unit for place, each in quantities(self).items()})

    def value(self, place: str) -> float:
        """Return the number at a dotted place, in SI units.

        Args:
            place: Such as ``plays.bridge.gap`` or ``links."motor mount".damping``.

        Raises:
            MechanismError: if there is none.
        """
        from trimmer.mechanism.places import value_at

        return value_at(self, place)

    def with_value(self, place: str, value: float | str) -> Mechanism:
        """Return the mechanism with another number at a dotted place.

        Args:
            place: Such as ``plays.bridge.gap`` or ``links."motor mount".damping``.
            value: The number in SI units, or text with a unit, such as ``40 um``.

        Raises:
            MechanismError: if there is no such place, or the number cannot stand there.
        """
        from trimmer.mechanism.places import with_value_at

        return with_value_at(self, place, value)

    def state_space(
        self,
        contacts: str | Mapping[str, str] = "closed",
        inputs: Iterable[str] | None = None,
        outputs: Iterable[str] | None = None,
    ) -> control.StateSpace:
        """Return the linear mechanism as a state space of python-control, in SI units, with signal names.

        Dry friction and rigid walls are left out; a viscous share is a damper. A closed contact is a spring
        and a damper at its middle, a curve its slope at rest.

        Args:
            contacts: ``closed`` or ``open``, all of them or by name; those not named are closed.
            inputs: Names of pins, by their displacements, and of forces, N; all of them if not given.
            outputs: Names of outputs, or of coordinates; all outputs if not given, all coordinates if there
                are none.

        Raises:
            MechanismError: if there is no such contact, input or output, or an output takes the rate of a
                pin's displacement.
        """
        from trimmer.mechanism.linear.state_space import state_space_of

        return state_space_of(self, contacts, inputs, outputs)


_JUDGED = (*COUPLINGS, "forces", *SECTIONS)
"""Sections whose numbers may not go together within an entry, and not beyond it."""


def changed(mechanism: Mechanism, place: tuple[str, ...], content: Any, value: float | str) -> Mechanism:
    """Return a mechanism in which one number, which was checked, has changed; others are not checked.

    Args:
        mechanism: The mechanism.
        place: Of the number.
        content: Of the field, with the number.
        value: The number as it was given, which is told where something else does not fit it.
    """
    field_name, name = place[0], "".join(place[1:2])
    contents = {**vars(mechanism), field_name: content}
    asked = contents
    if field_name == "points":  # Weights of points may leave any part without motion.
        contents.pop(WEIGHTS, None)
    else:
        alone = {name: content[name]} if field_name in _JUDGED else {}
        asked = {**contents, **{each: alone if each == field_name else {} for each in _JUDGED}}
    if problems := list(problems_of_numbers(asked, weighs=field_name == "points")):
        from trimmer.mechanism.place_text import place_text

        own = [each.place for each in problems] == [place]
        raise MechanismError(
            as_message(problems, "the mechanism" if own else f"with {place_text(place)} = {value}"),
            place=place,
        )
    made = object.__new__(Mechanism)
    vars(made).update(contents)
    return made


def problems_with(content: Mapping[str, Any]) -> list[Problem]:
    """Return what is wrong with the fields of a mechanism, by their names; empty if nothing is."""
    return list(problems_of_types(content)) or list(problems_of_sense(content))


def _taken(part: Any) -> Any:
    """Return a part with floats for all numbers, a tuple of ends, and a contact law for its word."""
    numbers = {
        name: quantity.taken(getattr(part, name))
        for name, quantity in QUANTITIES[type(part)].items()
        if getattr(part, name) is not None
    }
    if isinstance(part, Structure):
        return replace(part.taken(), damping_ratio=numbers.get("damping_ratio"))
    others: dict[str, object] = {}
    if hasattr(part, "between"):
        others["between"] = tuple(part.between)
    for key, form in number_rows.forms_of(part).items():
        if getattr(part, key) is not None:
            others[key] = number_rows.taken(getattr(part, key), form)
    if getattr(part, "waveform", None) is not None:
        others["waveform"] = tuple(map(float, part.waveform))
    if hasattr(part, "law"):
        others["law"] = ContactLaw.chosen(part.law, "law")
    return replace(part, **numbers, **others)
