"""The arrays of a mechanism: what its exact motion is computed from.

The extended state holds displacements q and velocities v of the bodies, the springs z of relaxing contacts,
sine and cosine of each order of the drive, the time if a pin that something leans on moves on for ever, and one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from trimmer.arrays import Integers, Places, Reals
from trimmer.contact.statuses import PULLS, RELAXES, TRUNCATES
from trimmer.mechanism.parts import GROUND, ContactLaw, Play, Stop

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.mechanism.parts import Force, Pin

_LAWS = {ContactLaw.RELAXING: RELAXES, ContactLaw.TRUNCATED: TRUNCATES, ContactLaw.PULLING: PULLS}


class Machine(NamedTuple):
    """The numbers of a mechanism; n bodies, m contacts, p frictions, N entries of the extended state.

    Attributes:
        base: Flow without contacts and dry friction, (N, N).
        contact_distance: s = end - start as functionals, (m, N).
        contact_rate: Its rate, (m, N).
        contact_push: Accelerations by a force of 1 N that pulls the ends together, (m, n).
        stiffness, damping: Of the contacts, N/m and N s/m, (m,).
        offsets: Distances at which contact begins on the plus side, and on the minus side with its sign, m,
            infinite for none: (m, 2).
        law: Contact laws, (m,).
        relaxing_state: Place of z in the extended state, -1 for none, (m,).
        always: Whether a contact has no gap and so never ends, (m,).
        friction_rate: Velocities of end relative to start as functionals, (p, N).
        friction_push: Accelerations by a force of 1 N on the end, (p, n).
        kinetic, static: Forces of the frictions, N, (p,).
        vertices: Bodies at start and end of the frictions, n for the ground, (p, 2).
    """

    base: Reals
    contact_distance: Reals
    contact_rate: Reals
    contact_push: Reals
    stiffness: Reals
    damping: Reals
    offsets: Reals
    law: Integers
    relaxing_state: Integers
    always: Integers
    friction_rate: Reals
    friction_push: Reals
    kinetic: Reals
    static: Reals
    vertices: Integers


@dataclass(frozen=True, eq=False)
class Layout:
    """Names and places in the extended state.

    Attributes:
        bodies: Names of the bodies.
        contacts: Names of plays and stops that exert a force.
        frictions: Names of the frictions that exert a force.
        relaxing: Names of those contacts whose z is a state.
        orders: Multiples of the drive's frequency that occur.
        ramp: Whether the time is an entry.
        omega: Angular frequency of the drive, rad/s; 0 without one.
        pins: Names of the pins.
        pin_rows: Displacements of the pins as functionals, (pins, N), without the share of a ramp that
            nothing leans on.
    """

    bodies: tuple[str, ...]
    contacts: tuple[str, ...]
    frictions: tuple[str, ...]
    relaxing: tuple[str, ...]
    orders: tuple[int, ...]
    ramp: bool
    omega: float
    pins: tuple[str, ...]
    pin_rows: Reals

    @property
    def state_count(self) -> int:
        """Number of states: displacements, velocities, relaxing springs."""
        return 2 * len(self.bodies) + len(self.relaxing)

    @property
    def size(self) -> int:
        """Number of entries of the extended state."""
        return self.state_count + 2 * len(self.orders) + int(self.ramp) + 1

    @property
    def period(self) -> float:
        """Period of the drive, s; 0 without one."""
        return 2 * np.pi / self.omega if self.omega else 0.0

    @property
    def forcing(self) -> int:
        """Number of entries that force the states and are not forced by them."""
        return self.size - self.state_count

    def sine(self, order: int) -> int:
        """Return the place of the sine of an order; its cosine follows."""
        return self.state_count + 2 * self.orders.index(order)

    def forcing_at(self, time: float, before: float = 0.0) -> Reals:
        """Return the entries that force the states, (forcing,).

        Args:
            time: s.
            before: Whole drive periods that were before, s, which count for ramps alone.
        """
        values = np.ones(self.forcing)
        for place, order in enumerate(self.orders):
            angle = order * self.omega * time
            values[2 * place : 2 * place + 2] = np.sin(angle), np.cos(angle)
        if self.ramp:
            values[-2] = before + time
        return values


def machine_of(mechanism: Mechanism) -> tuple[Machine, Layout]:
    """Return the arrays of a mechanism and the names of their rows."""
    contacts = {
        name: part
        for name, part in {**mechanism.plays, **mechanism.stops}.items()
        if part.stiffness > 0 or part.damping > 0
    }
    frictions = {name: part for name, part in mechanism.frictions.items() if part.static_force > 0}
    layout = _layout(mechanism, contacts, tuple(frictions))
    rows = _Rows(mechanism, layout)
    machine = Machine(
        base=_base(mechanism, layout, rows),
        **_contacts(contacts, layout, rows),
        **_frictions(mechanism, frictions, layout, rows),
    )
    return machine, layout


def _layout(mechanism: Mechanism, contacts: Mapping[str, Play | Stop], frictions: tuple[str, ...]) -> Layout:
    omega = 2 * np.pi * (mechanism.frequency or 0.0)
    moved: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    orders = sorted({part.order for part in moved if _moves(part)})
    leaning = {
        end
        for part in (*mechanism.links.values(), *contacts.values())
        if part.stiffness > 0
        for end in part.between
    }
    ramp = any(pin.velocity != 0 and name in leaning for name, pin in mechanism.pins.items())
    relaxing = tuple(
        name
        for name, part in contacts.items()
        if part.law is ContactLaw.RELAXING and part.damping > 0 and part.stiffness > 0
    )
    layout = Layout(
        tuple(mechanism.bodies),
        tuple(contacts),
        frictions,
        relaxing,
        tuple(orders),
        ramp,
        omega,
        tuple(mechanism.pins),
        np.zeros((0, 0)),
    )
    rows = _Rows(mechanism, layout)
    pin_rows = np.array([rows.displacement(name) for name in mechanism.pins]).reshape(-1, layout.size)
    return Layout(**{**layout.__dict__, "pin_rows": pin_rows})


def _moves(part: Pin | Force) -> bool:
    return part.amplitude != 0 or getattr(part, "unbalance", 0.0) != 0


@dataclass(frozen=True, eq=False)
class _Rows:
    """Displacements and velocities of ends as functionals of the extended state."""

    mechanism: Mechanism
    layout: Layout

    def displacement(self, end: str) -> Reals:
        row = np.zeros(self.layout.size)
        if end == GROUND:
            return row
        if end in self.mechanism.bodies:
            row[self.layout.bodies.index(end)] = 1.0
            return row
        pin = self.mechanism.pins[end]
        row += self.displacement(pin.on)
        row[-1] += pin.offset
        if self.layout.ramp:
            row[-2] += pin.velocity
        if pin.amplitude:
            self._add_wave(row, pin.order, pin.amplitude, pin.phase)
        return row

    def velocity(self, end: str) -> Reals:
        row = np.zeros(self.layout.size)
        if end == GROUND:
            return row
        count = len(self.layout.bodies)
        if end in self.mechanism.bodies:
            row[count + self.layout.bodies.index(end)] = 1.0
            return row
        pin = self.mechanism.pins[end]
        row += self.velocity(pin.on)
        row[-1] += pin.velocity
        if pin.amplitude:
            rate = pin.order * self.layout.omega * pin.amplitude
            self._add_wave(row, pin.order, rate, pin.phase + np.pi / 2)
        return row

    def _add_wave(self, row: Reals, order: int, amplitude: float, phase: float) -> None:
        """Add amplitude sin(order w t + phase)."""
        sine = self.layout.sine(order)
        row[sine] += amplitude * np.cos(phase)
        row[sine + 1] += amplitude * np.sin(phase)

    def wave(self, order: int, amplitude: float, phase: float) -> Reals:
        row = np.zeros(self.layout.size)
        self._add_wave(row, order, amplitude, phase)
        return row

    def carrier(self, end: str) -> int:
        """Return the number of the body that a force on an end acts on; the number of bodies for none."""
        body = self.mechanism.pins[end].on if end in self.mechanism.pins else end
        return len(self.layout.bodies) if body == GROUND else self.layout.bodies.index(body)

    def push(self, start: str, end: str) -> Reals:
        """Return the accelerations by a force of 1 N that pushes the end and its opposite on the start."""
        masses = np.array([body.mass for body in self.mechanism.bodies.values()])
        forces = np.zeros(len(masses) + 1)
        forces[self.carrier(end)] += 1.0
        forces[self.carrier(start)] -= 1.0
        return np.asarray(forces[:-1] / masses)


def _base(mechanism: Mechanism, layout: Layout, rows: _Rows) -> Reals:
    count = len(layout.bodies)
    base = np.zeros((layout.size, layout.size))
    base[:count, count : 2 * count] = np.eye(count)
    for link in mechanism.links.values():
        start, end = link.between
        force = link.stiffness * (rows.displacement(end) - rows.displacement(start))
        force += link.damping * (rows.velocity(end) - rows.velocity(start))
        base[count : 2 * count] -= np.outer(rows.push(start, end), force)
    for friction in mechanism.frictions.values():
        start, end = friction.between
        drag = friction.viscous * (rows.velocity(end) - rows.velocity(start))
        base[count : 2 * count] -= np.outer(rows.push(start, end), drag)
    for force_on in mechanism.forces.values():
        push = rows.push(GROUND, force_on.on)
        base[count : 2 * count, -1] += push * force_on.constant
        if _moves(force_on):
            amplitude = force_on.amplitude + force_on.unbalance * (force_on.order * layout.omega) ** 2
            base[count : 2 * count] += np.outer(push, rows.wave(force_on.order, amplitude, force_on.phase))
    for order in layout.orders:
        sine = layout.sine(order)
        base[sine, sine + 1] = order * layout.omega
        base[sine + 1, sine] = -order * layout.omega
    if layout.ramp:
        base[-2, -1] = 1.0
    return base


def _contacts(
    contacts: Mapping[str, Play | Stop], layout: Layout, rows: _Rows
) -> dict[str, Reals | Integers]:
    count = len(contacts)
    parts = list(contacts.values())
    between = [part.between for part in parts]
    first = 2 * len(layout.bodies)
    return {
        "contact_distance": _stacked(
            [rows.displacement(end) - rows.displacement(start) for start, end in between], layout.size
        ),
        "contact_rate": _stacked(
            [rows.velocity(end) - rows.velocity(start) for start, end in between], layout.size
        ),
        "contact_push": _stacked([-rows.push(start, end) for start, end in between], len(layout.bodies)),
        "stiffness": np.array([part.stiffness for part in parts], dtype=np.float64),
        "damping": np.array([part.damping for part in parts], dtype=np.float64),
        "offsets": np.array([_offsets(part) for part in parts], dtype=np.float64).reshape(count, 2),
        "law": np.array([PULLS if p.damping == 0 else _LAWS[p.law] for p in parts], dtype=np.int64),
        "relaxing_state": np.array(
            [first + layout.relaxing.index(name) if name in layout.relaxing else -1 for name in contacts],
            dtype=np.int64,
        ),
        "always": np.array([_never_ends(part) for part in parts], dtype=np.int64),
    }


def _offsets(part: Play | Stop) -> tuple[float, float]:
    return (part.gap / 2, -part.gap / 2) if isinstance(part, Play) else (part.gap, -np.inf)


def _never_ends(part: Play | Stop) -> bool:
    """Return whether a part is a link: a play without gap, unless its law cuts off the pull of its damper."""
    truncates = part.law is ContactLaw.TRUNCATED and part.damping > 0
    return isinstance(part, Play) and part.gap == 0 and not truncates


def _frictions(
    mechanism: Mechanism, frictions: Mapping[str, object], layout: Layout, rows: _Rows
) -> dict[str, Reals | Integers]:
    parts = [mechanism.frictions[name] for name in frictions]
    between = [part.between for part in parts]
    return {
        "friction_rate": _stacked(
            [rows.velocity(end) - rows.velocity(start) for start, end in between], layout.size
        ),
        "friction_push": _stacked([rows.push(start, end) for start, end in between], len(layout.bodies)),
        "kinetic": np.array([part.force for part in parts], dtype=np.float64),
        "static": np.array([part.static_force for part in parts], dtype=np.float64),
        "vertices": np.array(
            [[rows.carrier(start), rows.carrier(end)] for start, end in between], dtype=np.int64
        ).reshape(-1, 2),
    }


def _stacked(rows: list[Reals], size: int) -> Reals:
    return np.array(rows, dtype=np.float64).reshape(-1, size)


def independent(vertices: Integers, frictions: Places) -> Places:
    """Return those of some frictions that hold them all together, without rings: numbers, in order.

    Bodies and the ground are vertices of a graph and the frictions its edges; these are a spanning tree.
    """
    parents = list(range(int(vertices.max(initial=0)) + 1))

    def root(vertex: int) -> int:
        while parents[vertex] != vertex:
            vertex = parents[vertex]
        return vertex

    tree = []
    for friction in frictions:
        start, end = (root(int(vertex)) for vertex in vertices[friction])
        if start != end:
            parents[start] = end
            tree.append(friction)
    return np.array(tree, dtype=np.intp)
