"""Parts of a mechanism of numbers as parts of one of symbols; coefficients that are zero stay zero."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from derivations import parts, symbols
from derivations.algebra.unevaluated import product, total
from derivations.mechanism import Mechanism as SymbolicMechanism
from derivations.mechanism import elongation, elongation_rate
from derivations.symbols import t
from trimmer.in_symbols.controllers import controls_of
from trimmer.in_symbols.printed_symbols import WEIGHT, Place, PrintedSymbol
from trimmer.in_symbols.structures import StructuresInSymbols
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.number_rows import value_at
from trimmer.mechanism.parts import GROUND, Curve, Force, Output, OutputKind, Pin, Play, Stop, Wall


@dataclass(frozen=True)
class Translation:
    """A mechanism on its way into its symbols."""

    data: Mechanism
    printed: Mapping[Place, PrintedSymbol]

    def mechanism(self) -> SymbolicMechanism:
        """Return the mechanism in symbols."""
        structures = StructuresInSymbols(self.data, self.printed)
        bodies = {name: self._body(name) for name in self.data.bodies} | structures.bodies
        points = {name: self._point(name, bodies) for name in self.data.points} | structures.points
        moved: dict[str, parts.RigidBody | parts.Point] = {**bodies, **points}
        carriers: dict[str, parts.RigidBody | parts.Point | parts.Ground] = {GROUND: parts.Ground(), **moved}
        pins = {name: self._pin(name, pin, carriers[pin.on]) for name, pin in self.data.pins.items()}
        ends: dict[str, parts.End] = {**carriers, **pins}
        return SymbolicMechanism(
            bodies=tuple(bodies.values()),
            springs=(*self._springs(ends), *structures.springs),
            dampers=(*self._dampers(ends), *structures.dampers),
            pins=tuple(pins.values()),
            contacts=(
                *(self._play(name, play, ends) for name, play in self.data.plays.items() if _pushes(play)),
                *(self._stop(name, stop, ends) for name, stop in self.data.stops.items() if _pushes(stop)),
                *(
                    parts.CurvedSpring(
                        name,
                        *_two(link.between, ends),
                        self._function("links", name, "elongation"),
                        self._function("links", name, "tension"),
                        _points(link.curve),
                    )
                    for name, link in self.data.links.items()
                    if link.curve
                ),
                *(self._wall(name, wall, ends) for name, wall in self.data.walls.items()),
            ),
            frictions=tuple(
                self._friction(name, ends)
                for name, friction in self.data.frictions.items()
                if friction.static_force != 0
            ),
            forces=(
                *(self._force(name, force, moved) for name, force in self.data.forces.items()),
                *(self._control(name, carriers) for name in self.data.controllers),
            ),
            controls=tuple(controls_of(self.data, self._function)),
            outputs=tuple(self._output(name, output, ends) for name, output in self.data.outputs.items()),
            points=tuple(points.values()),
            structures=structures.structures,
        )

    def _body(self, name: str) -> parts.RigidBody:
        turns = self.data.kinds[name] is Kind.ROTATION
        mass = self.data.bodies[name].generalised_mass
        symbol = self._number("bodies", name, "inertia" if turns else "mass", mass)
        return parts.RigidBody(name, symbol, self._function("bodies", name, "coordinate"), turns)

    def _point(self, name: str, bodies: Mapping[str, parts.RigidBody]) -> parts.Point:
        weights = tuple(
            (bodies[of], self._weight(name, of, weight))
            for of, weight in self.data.points[name].weights.items()
            if weight != 0
        )
        return parts.Point(self._function("points", name, "displacement"), weights)

    def _weight(self, name: str, of: str, weight: float) -> sympy.Expr:
        if ("points", name, f"{WEIGHT}{of}") not in self.printed:
            return sympy.Integer(int(weight))
        return self._number("points", name, f"{WEIGHT}{of}", weight)

    def _pin(self, name: str, pin: Pin, carrier: parts.RigidBody | parts.Point | parts.Ground) -> parts.Pin:
        offset = self._number("pins", name, "offset", pin.offset)
        velocity = self._number("pins", name, "velocity", pin.velocity)
        amplitude = self._number("pins", name, "amplitude", pin.amplitude)
        wave = product(amplitude, self._wave("pins", name, pin))
        law = total(
            *(offset, product(velocity, t) if velocity != 0 else 0, wave if amplitude != 0 else 0),
            *self._further("pins", name, pin),
        )
        return parts.Pin(carrier, self._function("pins", name, "displacement"), law)

    def _force(
        self, name: str, force: Force, moved: Mapping[str, parts.RigidBody | parts.Point]
    ) -> parts.Force:
        constant = self._number("forces", name, "constant", force.constant)
        amplitude = self._number("forces", name, "amplitude", force.amplitude)
        unbalance = self._number("forces", name, "unbalance", force.unbalance)
        height = total(amplitude, unbalance * (force.order * self._omega(force)) ** 2)
        wave = product(height, self._wave("forces", name, force))
        profile = [self._function("forces", name, "profile")] if force.profile else []
        law = total(constant, wave if height != 0 else 0, *self._further("forces", name, force), *profile)
        return parts.Force(moved[force.on], self._function("forces", name, "value"), law)

    def _control(
        self, name: str, carriers: Mapping[str, parts.RigidBody | parts.Point | parts.Ground]
    ) -> parts.Force:
        start, end = self.data.controllers[name].acts
        value = self._function("controllers", name, "value")
        return parts.Force(carriers[end], value, against=carriers[start])

    def _output(self, name: str, output: Output, ends: Mapping[str, Any]) -> parts.Output:
        value = self._function("outputs", name, "value")
        if output.kind is OutputKind.CONTROL:
            return parts.Output(value, (), force=self._function("controllers", str(output.part), "value"))
        if output.part is not None:
            return parts.Output(value, (), force=self._force_of(output.part, ends))
        weights = tuple(
            (ends[end], sympy.nsimplify(weight, rational=True)) for end, weight in output.weights.items()
        )
        return parts.Output(value, weights, output.kind.value)

    def _force_of(self, part: str, ends: Mapping[str, parts.End]) -> sympy.Expr:
        """Return the force of a link, play, stop, wall or friction."""
        if part in self.data.walls:
            return self._function("walls", part, "tension")
        for section, contacts in (("plays", self.data.plays), ("stops", self.data.stops)):
            if part in contacts:
                return self._function(section, part, "tension") if _pushes(contacts[part]) else sympy.S.Zero
        if part in self.data.links:
            link = self.data.links[part]
            stiffness = self._number("links", part, "stiffness", link.stiffness)
            spring = parts.Spring(stiffness, *_two(link.between, ends))
            damping = self._number("links", part, "damping", link.damping)
            return total(
                _times(stiffness, elongation(spring)),
                _times(damping, elongation_rate(spring)),
                self._function("links", part, "tension") if link.curve else 0,
            )
        friction = self.data.frictions[part]
        dry = self._function("frictions", part, "dry") if friction.static_force else sympy.S.Zero
        drag = self._number("frictions", part, "viscous", friction.viscous)
        return total(dry, _times(drag, elongation_rate(parts.Damper(drag, *_two(friction.between, ends)))))

    def _wave(self, section: str, name: str, part: Pin | Force) -> sympy.Expr:
        phase = self._number(section, name, "phase", part.phase)
        return sympy.sin(total(part.order * self._omega(part) * t, phase))

    def _omega(self, part: Pin | Force) -> sympy.Expr:
        """Return the angular frequency of what drives a part."""
        if part.drive is None:
            return symbols.omega
        return sympy.Symbol(self.printed["drives", part.drive, "omega"].symbol, real=True)

    def _further(self, section: str, name: str, part: Pin | Force) -> Iterator[sympy.Expr]:
        """Yield the harmonics of a part, and its waveform."""
        for number, (order, *_) in enumerate(part.harmonics or (), start=1):
            amplitude, phase = (
                self._number(
                    section, name, f"harmonics.{number}.{of}", value_at(part, "harmonics", str(number), of)
                )
                for of in ("amplitude", "phase")
            )
            if amplitude != 0:
                yield product(amplitude, sympy.sin(total(int(order) * self._omega(part) * t, phase)))
        if part.waveform:
            yield self._function(section, name, "waveform")

    def _springs(self, ends: Mapping[str, parts.End]) -> tuple[parts.Spring, ...]:
        return tuple(
            parts.Spring(self._number("links", name, "stiffness", link.stiffness), *_two(link.between, ends))
            for name, link in self.data.links.items()
            if link.stiffness != 0
        )

    def _dampers(self, ends: Mapping[str, parts.End]) -> tuple[parts.Damper, ...]:
        of_links = (
            parts.Damper(self._number("links", name, "damping", link.damping), *_two(link.between, ends))
            for name, link in self.data.links.items()
            if link.damping != 0
        )
        only_viscous = (
            parts.Damper(self._number("frictions", name, "viscous", each.viscous), *_two(each.between, ends))
            for name, each in self.data.frictions.items()
            if each.static_force == 0 and each.viscous != 0
        )
        return (*of_links, *only_viscous)

    def _play(self, name: str, play: Play, ends: Mapping[str, parts.End]) -> parts.Play:
        side = sympy.Symbol(self.printed["plays", name, "side"].symbol, real=True)
        return parts.Play(**self._contact("plays", name, play, ends), side=side)

    def _stop(self, name: str, stop: Stop, ends: Mapping[str, parts.End]) -> parts.Stop:
        return parts.Stop(**self._contact("stops", name, stop, ends))

    def _wall(self, name: str, wall: Wall, ends: Mapping[str, parts.End]) -> parts.Wall:
        numbers = (self._number("walls", name, of, getattr(wall, of)) for of in ("restitution", "gap"))
        functions = (self._function("walls", name, of) for of in ("distance", "tension"))
        return parts.Wall(name, *_two(wall.between, ends), *numbers, *functions)

    def _contact(
        self, section: str, name: str, contact: Play | Stop, ends: Mapping[str, parts.End]
    ) -> dict[str, Any]:
        numbers = ("stiffness", "damping", "gap")
        start, end = _two(contact.between, ends)
        return {
            **{of: self._number(section, name, of, getattr(contact, of)) for of in numbers},
            **{of: self._function(section, name, of) for of in ("distance", "stretch", "tension")},
            **{"name": name, "start": start, "end": end, "law": parts.ContactLaw[contact.law.name]},
        }

    def _friction(self, name: str, ends: Mapping[str, parts.End]) -> parts.Friction:
        friction = self.data.frictions[name]
        kinetic = self._number("frictions", name, "force", friction.kinetic_force)
        static = self._number("frictions", name, "static", friction.static_force)
        return parts.Friction(
            name,
            kinetic,
            kinetic if friction.static_force == friction.force else static,
            self._number("frictions", name, "viscous", friction.viscous),
            *_two(friction.between, ends),
            self._function("frictions", name, "rate"),
            self._function("frictions", name, "dry"),
            _points(friction.curve) if friction.curve else (),
        )

    def _number(self, section: str, name: str, of: str, value: float) -> sympy.Expr:
        """Return the symbol of a number, or zero; assumed is no more than the kind of number says."""
        if value == 0:
            return sympy.S.Zero
        assumed = {"mass": "positive", "inertia": "positive"}
        assumed |= dict.fromkeys(("stiffness", "damping", "viscous"), "nonnegative")
        return sympy.Symbol(self.printed[section, name, of].symbol, **{assumed.get(of, "real"): True})

    def _function(self, section: str, name: str, of: str) -> sympy.Expr:
        return sympy.Function(self.printed[section, name, of].symbol, real=True)(t)


def _times(coefficient: sympy.Expr, motion: sympy.Expr) -> sympy.Expr:
    return sympy.S.Zero if coefficient == 0 else product(coefficient, motion)


def _two(between: tuple[str, str], ends: Mapping[str, parts.End]) -> tuple[parts.End, parts.End]:
    start, end = between
    return ends[start], ends[end]


def _points(curve: Curve) -> parts.Points:
    """Return the points of a curve as the decimals that they are written with."""
    return tuple((sympy.Rational(repr(x)), sympy.Rational(repr(y))) for x, y in curve)


def _pushes(contact: Play | Stop) -> bool:
    return contact.stiffness != 0 or contact.damping != 0
