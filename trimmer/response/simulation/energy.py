"""Energy balance of a mechanism's motion: what pins and forces put in, what each part stores and loses.

Every force between two ends is a tension that pulls them together; its power goes into a spring, or is lost.
The integrals are sums over the nodes of the motion, exact to rounding; nothing is made to close.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.machine.statuses import RELAXING, STICK
from trimmer.contact.modes.assembly import PUSHING, offset
from trimmer.contact.readouts.control_readouts import control_signal
from trimmer.contact.readouts.curve_forces import force_signal, stored_energy
from trimmer.contact.readouts.friction_forces import hold_forces, undetermined
from trimmer.contact.readouts.impacts import losses_at_walls, work_at_walls
from trimmer.contact.readouts.outputs import contact_force
from trimmer.contact.state.rows import EndRows
from trimmer.mechanism import Mechanism, Play, Stop
from trimmer.mechanism.coordinates import inertia_of, rows_of_structures
from trimmer.motion.course import Course
from trimmer.motion.signals import Signal, along, while_status
from trimmer.showing.shown import Tabular
from trimmer.showing.table import TERMS, Table


@dataclass(frozen=True, repr=False)
class MechanismEnergy(Tabular):
    """Energies and works of a motion from its start to its end, J.

    Attributes:
        kinetic: Kinetic energy at start and end.
        stored: Energy of all springs at start and end, those behind slots among them.
        pins: Work of what moves each pin relative to its carrier.
        forces: Work of each force.
        dampers: Lost in each link.
        contacts: Lost in each play and stop.
        walls: Lost at each wall.
        frictions: Lost in each friction, with its viscous part.
        structures: Lost in each structure.
        controllers: Work of each controller.
        undetermined: Frictions on pins whose force in stick the motion leaves open at some time. The works of
            these pins rest on how they share it (``contact.readouts.friction_forces``); no other number does.
        residual: What does not close, as a share of the largest term.
    """

    kinetic: tuple[float, float]
    stored: tuple[float, float]
    pins: Mapping[str, float]
    forces: Mapping[str, float]
    dampers: Mapping[str, float]
    contacts: Mapping[str, float]
    frictions: Mapping[str, float]
    walls: Mapping[str, float]
    undetermined: tuple[str, ...] = ()
    structures: Mapping[str, float] = field(default_factory=dict)
    controllers: Mapping[str, float] = field(default_factory=dict)
    residual: float = field(init=False)

    def __post_init__(self) -> None:
        terms = [
            *(self.kinetic[1], -self.kinetic[0], self.stored[1], -self.stored[0]),
            *(-work for works in (self.pins, self.forces, self.controllers) for work in works.values()),
            *(loss for losses in self._losses for loss in losses.values()),
        ]
        largest = max(map(abs, terms))
        object.__setattr__(self, "residual", abs(sum(terms)) / largest if largest else 0.0)

    @property
    def work(self) -> float:
        """Work of pins, forces and controllers together."""
        return sum(sum(each.values()) for each in (self.pins, self.forces, self.controllers))

    @property
    def loss(self) -> float:
        """All losses together."""
        return sum(sum(each.values()) for each in self._losses)

    @property
    def _losses(self) -> tuple[Mapping[str, float], ...]:
        return self.dampers, self.contacts, self.frictions, self.walls, self.structures

    def _told(self) -> str:
        closing = f"it closes to {self.residual:.1e} of its largest term"
        return f"work {self.work:.6g} J, loss {self.loss:.6g} J; {closing}"

    def _table(self) -> Table:
        names = ("pins", "forces", "controllers", "dampers", "contacts", "frictions", "walls", "structures")
        parts = [
            (f"{section}.{name}", each) for section in names for name, each in getattr(self, section).items()
        ]
        ends = [
            (f"{section}, {when}", each)
            for section in ("kinetic", "stored")
            for when, each in zip(("start", "end"), getattr(self, section), strict=True)
        ]
        return Table("Energies and works", [*ends, *parts], TERMS)


def energy_of(mechanism: Mechanism, course: Course) -> MechanismEnergy:
    """Return the energy balance of a motion."""
    return _Balance(mechanism, course).made()


@dataclass(frozen=True, eq=False)
class _Balance:
    mechanism: Mechanism
    course: Course

    def made(self) -> MechanismEnergy:
        first, last = self.ends
        return MechanismEnergy(
            (self.kinetic(first), self.kinetic(last)),
            (self.stored(first, 0), self.stored(last, -1)),
            {name: self.of_pin(name) for name in self.mechanism.pins},
            {name: self.of_force(name) for name in self.mechanism.forces},
            {name: self.integral(link.damping * self.rate(link.between) ** 2)
             for name, link in self.mechanism.links.items()},
            {name: self.of_contact(number)
             for number, name in enumerate(self.course.modes.system.layout.contacts)},
            {name: self.of_friction(name) for name in self.mechanism.frictions},
            losses_at_walls(self.course),
            tuple(
                name for name in undetermined(self.course)
                if self.mechanism.pins.keys() & set(self.between(name))
            ),
            dict(self.of_structures()),
            {name: self.of_controller(name) for name in self.mechanism.controllers},
        )  # fmt: skip

    def between(self, name: str) -> tuple[str, str]:
        frictions = self.mechanism.frictions
        return frictions[name].between if name in frictions else self.mechanism.walls[name].between

    @cached_property
    def ends(self) -> tuple[Reals, Reals]:
        """Extended states at start and end."""
        return self.course.log.state[0], self.course.states(np.array([self.course.duration]))[0]

    @cached_property
    def rows(self) -> EndRows:
        """The ends as functionals."""
        return EndRows(self.mechanism, self.course.modes.system.layout)

    def integral(self, values: Reals) -> float:
        return float(self.course.nodes.weights @ values)

    def at_nodes(self, row: Reals) -> Reals:
        return np.asarray(self.course.nodes.states @ row)

    def of(self, signal: Signal) -> Reals:
        return along(self.course, signal, self.course.nodes.rows, self.course.nodes.states)

    def rate(self, between: tuple[str, str]) -> Reals:
        return self.at_nodes(self.rows.speed(between))

    def kinetic(self, state: Reals) -> float:
        mass = inertia_of(self.mechanism).matrix
        velocities = state[len(mass) : 2 * len(mass)]
        return float(0.5 * velocities @ mass @ velocities)

    def stored(self, state: Reals, row: int) -> float:
        mode = int(self.course.log.mode[row])
        energy: Any = 0.0
        for link in self.mechanism.links.values():
            energy += 0.5 * link.stiffness * (self.rows.distance(link.between) @ state) ** 2
        machine = self.course.modes.system.machine
        for curve, (section, _) in enumerate(self.course.modes.system.layout.curves):
            if section == "links":
                energy += stored_energy(machine, curve, state)
        for structure, rows in rows_of_structures(self.mechanism):
            energy += 0.5 * state[rows] @ structure.matrices[2] @ state[rows]
        for contact, stiffness in enumerate(self.course.modes.system.machine.stiffness):
            energy += 0.5 * stiffness * (self.stretch(contact)(mode) @ state) ** 2
        return float(energy)

    def of_structures(self) -> Iterator[tuple[str, float]]:
        """Yield what each structure loses."""
        count = len(self.mechanism.coordinates)
        velocities = self.course.nodes.states[:, count : 2 * count]
        for name, (structure, rows) in zip(
            self.mechanism.structures, rows_of_structures(self.mechanism), strict=True
        ):
            here = velocities[:, rows]
            yield name, self.integral(((here @ structure.matrices[1]) * here).sum(axis=1))

    def stretch(self, contact: int) -> Signal:
        """Return the stretch of a spring behind a slot as a signal, m."""
        modes = self.course.modes

        def row(mode: int) -> Reals:
            status, found = modes[mode].statuses[contact], np.zeros(modes.system.layout.size)
            if status in PUSHING:
                found = modes.system.machine.contact_distance[contact].copy()
                found[-1] -= offset(modes.system.machine, contact, status)
            elif status == RELAXING:
                found[modes.system.machine.relaxing_state[contact]] = 1.0
            return found

        return row

    def of_contact(self, contact: int) -> float:
        """Return what a contact loses: to its damper, and what its spring holds when the law forgets it."""
        modes, log = self.course.modes, self.course.log
        machine = modes.system.machine
        rate = machine.contact_rate[contact]
        idle = np.zeros(modes.system.layout.size)
        pushes = self.of(lambda mode: rate if modes[mode].statuses[contact] in PUSHING else idle)
        lost = machine.damping[contact] * self.integral(pushes**2)
        stretch, rows = self.stretch(contact), np.arange(len(log.mode))
        following = np.vstack([log.state[1:], self.ends[1]])
        relaxing = modes.tables.statuses[log.mode, contact] == RELAXING
        squares = along(self.course, stretch, rows, log.state) ** 2
        at_end = along(self.course, stretch, rows, following) ** 2
        at_end[relaxing] = self.relaxed(contact, squares)[relaxing]
        relaxed = (squares - at_end)[relaxing].sum()
        forgotten = (at_end[:-1] - squares[1:]).sum()
        return float(lost + 0.5 * machine.stiffness[contact] * (relaxed + forgotten))

    def relaxed(self, contact: int, squares: Reals) -> Reals:
        """Return the squares of a stretch after it has relaxed for the time of each segment."""
        machine = self.course.modes.system.machine
        if machine.damping[contact] == 0:
            return squares
        times = np.diff(np.append(self.course.log.start, self.course.duration))
        return np.asarray(
            squares * np.exp(-2 * machine.stiffness[contact] / machine.damping[contact] * times)
        )

    def of_friction(self, name: str) -> float:
        friction = self.mechanism.frictions[name]
        speeds = self.rate(friction.between)
        lost = friction.viscous * self.integral(speeds**2)
        lost += self.integral(self.of(force_signal(self.course.modes, "frictions", name)) * speeds)
        if name in self.course.modes.system.layout.frictions:
            number = self.course.modes.system.layout.frictions.index(name)
            contacts = len(self.course.modes.system.machine.stiffness)
            sticks = while_status(self.course, contacts + number, (STICK,))[self.course.nodes.rows]
            kinetic = float(self.course.modes.system.machine.kinetic[number])
            lost += kinetic * self.integral(np.where(sticks, 0.0, abs(speeds)))
        return lost

    @cached_property
    def held(self) -> Reals:
        """Tensions of frictions, then of walls at rest, at the nodes, N, (count, frictions + walls)."""
        return hold_forces(self.course, self.course.nodes.rows, self.course.nodes.states)

    def of_pin(self, name: str) -> float:
        """Return the work of what moves a pin, against the tensions of all that it is an end of."""
        rate = self.rows.speed((self.mechanism.pins[name].on, name))
        own = self.at_nodes(rate)
        pull = np.zeros(len(own))
        for between, tension in self.tensions:
            pull += tension * ((between[1] == name) - (between[0] == name))
        return self.integral(pull * own) + work_at_walls(self.course, self.mechanism, name, rate)

    @cached_property
    def tensions(self) -> list[tuple[tuple[str, str], Reals]]:
        """Ends and tension at the nodes, N, of each part."""
        mechanism, layout = self.mechanism, self.course.modes.system.layout
        found = []
        modes = self.course.modes
        for name, link in mechanism.links.items():
            stretch = self.at_nodes(self.rows.distance(link.between))
            tension = link.stiffness * stretch + link.damping * self.rate(link.between)
            found.append((link.between, tension + self.of(force_signal(modes, "links", name))))
        contacts: dict[str, Play | Stop] = {**mechanism.plays, **mechanism.stops}
        for number, name in enumerate(layout.contacts):
            found.append((contacts[name].between, self.of(contact_force(self.course.modes, number))))
        for name, wall in mechanism.walls.items():
            number = len(layout.frictions) + layout.walls.index(name)
            found.append((wall.between, self.held[:, number]))
        for name, friction in mechanism.frictions.items():
            tension = friction.viscous * self.rate(friction.between)
            tension = tension + self.of(force_signal(modes, "frictions", name))
            if name in layout.frictions:
                tension = tension + self.held[:, layout.frictions.index(name)]
            found.append((friction.between, tension))
        return found

    def of_controller(self, name: str) -> float:
        acts = self.of(control_signal(self.course.modes, name))
        return self.integral(acts * self.rate(self.mechanism.controllers[name].acts))

    def of_force(self, name: str) -> float:
        force = self.mechanism.forces[name]
        given, velocity = self.rows.given(force), self.rows.velocity(force.on)
        return self.integral(self.at_nodes(given) * self.at_nodes(velocity))
