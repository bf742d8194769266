"""The arrays of a mechanism: what its exact motion is computed from."""

from collections.abc import Iterable, Mapping
from itertools import starmap
from typing import Any, NamedTuple

import numpy as np

from trimmer.arrays import Integers, Places, Reals
from trimmer.contact.machine.control_arrays import control_arrays
from trimmer.contact.machine.curve_arrays import curve_arrays
from trimmer.contact.machine.statuses import PULLS, RELAXES, TRUNCATES
from trimmer.contact.state.frame import Frame
from trimmer.contact.state.laid_out import layout_of
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.rows import EndRows
from trimmer.hybrid.system import NO_STATE
from trimmer.mechanism import GROUND, ContactLaw, Mechanism, Play, Stop
from trimmer.mechanism.coordinates import elastic_matrices

_LAWS = {ContactLaw.RELAXING: RELAXES, ContactLaw.TRUNCATED: TRUNCATES, ContactLaw.PULLING: PULLS}


class Machine(NamedTuple):
    """The numbers of a mechanism; n bodies, m contacts, p frictions, N entries of the extended state."""

    base: Reals  # Flow without contacts and dry friction, (N, N)
    contact_distance: Reals  # s = end - start as functionals, (m, N)
    contact_rate: Reals  # Its rate, (m, N)
    contact_push: Reals  # Accelerations by a force of 1 N that pulls the ends together, (m, n)
    # stiffness, damping: Of the contacts, N/m and N s/m, (m,)
    stiffness: Reals
    damping: Reals
    # Distances at which contact begins on the plus side, and on the minus side with its sign, m, infinite for
    # none: (m, 2)
    offsets: Reals
    law: Integers  # Contact laws, (m,)
    relaxing_state: Integers  # Place of z in the extended state, ``NO_STATE`` for none, (m,)
    always: Integers  # Whether a contact has no gap and so never ends, (m,)
    friction_rate: Reals  # Velocities of end relative to start as functionals, (p, N)
    friction_push: Reals  # Accelerations by a force of 1 N on the end, (p, n)
    # kinetic, static: Forces of the frictions, N, (p,)
    kinetic: Reals
    static: Reals
    curve_over: Reals  # Distances or velocities that the forces of c curves go by, as functionals, (c, N)
    curve_push: Reals  # Accelerations by a force of 1 N that pulls the ends together, (c, n)
    curve_knots: Reals  # Where one segment ends and the next begins, infinite for none, (c, knots)
    # curve_slopes, curve_heights: The force of a segment is slope x + height, N, (c, knots + 1)
    curve_slopes: Reals
    curve_heights: Reals
    curve_by_speed: Integers  # Whether each goes by a velocity, (c,)
    # wall_distance, wall_rate: end - start of w walls less the gap, and its rate, as functionals, (w, N)
    wall_distance: Reals
    wall_rate: Reals
    wall_push: Reals  # Accelerations by a force of 1 N on the end, (w, n)
    restitution: Reals  # Of the walls, (w,)
    control_demand: Reals  # What k controllers demand before their limits, as functionals, (k, N)
    control_effect: Reals  # Rates of the states by what is left of that, in N, (k, N)
    control_tracking: Reals  # Rates of the states by what the limit takes away, (k, N)
    control_rest: Reals  # What acts beside the share of what is left, as functionals, (k, N)
    control_limit: Reals  # Of the controllers, N, infinite for none, (k,)
    control_through: Reals  # That share, (k,)

    def of_frictions(self, statuses: tuple[int, ...]) -> tuple[int, ...]:
        """Return the statuses of the frictions out of those of all parts."""
        first = len(self.stiffness)
        return statuses[first : first + len(self.kinetic)]

    def of_curves(self, statuses: tuple[int, ...]) -> tuple[int, ...]:
        """Return the segments of the curves out of the statuses of all parts."""
        count = len(self.curve_over)
        return statuses[self.first_curve :][:count] if count else ()

    def of_controls(self, statuses: tuple[int, ...]) -> tuple[int, ...]:
        """Return the statuses of the controllers out of those of all parts."""
        count = len(self.control_limit)
        return statuses[self.first_control :][:count] if count else ()

    def of_walls(self, statuses: tuple[int, ...]) -> tuple[int, ...]:
        """Return the statuses of the walls out of those of all parts: they come last."""
        return statuses[len(statuses) - len(self.restitution) :]

    @property
    def first_curve(self) -> int:
        """Number of the first curve among all parts: behind contacts and frictions."""
        return len(self.stiffness) + len(self.kinetic)

    @property
    def first_control(self) -> int:
        """Number of the first controller: behind the curves."""
        return self.first_curve + len(self.curve_over)

    @property
    def first_wall(self) -> int:
        """Number of the first wall: behind all others."""
        return self.first_control + len(self.control_limit)

    @property
    def velocities(self) -> slice:
        """Places of the velocities in the extended state: behind the displacements."""
        bodies = self.contact_push.shape[1]
        return slice(bodies, 2 * bodies)

    @property
    def holds(self) -> Places:
        """Numbers among all parts of what may hold two ends together: frictions, then walls."""
        frictions, walls = np.arange(len(self.stiffness), self.first_curve), np.arange(len(self.restitution))
        return np.concatenate([frictions, self.first_wall + walls])

    @property
    def hold_rate(self) -> Reals:
        """Velocities of end relative to start of what may hold, as functionals, (p + w, N)."""
        return np.concatenate([self.friction_rate, self.wall_rate])

    @property
    def hold_push(self) -> Reals:
        """Accelerations by a force of 1 N on the end of what may hold, (p + w, n)."""
        return np.concatenate([self.friction_push, self.wall_push])

    @property
    def held(self) -> Reals:
        """Largest forces in stick, N, of walls infinite, (p + w,); those of walls hold one way only."""
        return np.concatenate([self.static, np.full(len(self.restitution), np.inf)])


def machine_of(mechanism: Mechanism, frame: Frame | None = None) -> tuple[Machine, MechanismLayout]:
    """Return the arrays of a mechanism, in the frame of the ground or a given one, and their rows' names."""
    parts: dict[str, Play | Stop] = {**mechanism.plays, **mechanism.stops}
    contacts = {name: part for name, part in parts.items() if part.stiffness > 0 or part.damping > 0}
    frictions = {name: part for name, part in mechanism.frictions.items() if part.static_force > 0}
    layout = layout_of(mechanism, contacts, tuple(frictions), frame)
    rows = EndRows(mechanism, layout)
    base = _base(mechanism, layout, rows)
    machine = Machine(
        base=base,
        **_contacts(contacts, layout, rows),
        **_frictions(mechanism, frictions, layout, rows),
        **curve_arrays(mechanism, rows),
        **_walls(mechanism, layout, rows),
        **control_arrays(mechanism, rows, base),
    )
    return machine, layout


def relaxing_springs(machine: Machine) -> list[tuple[int, int]]:
    """Return the contacts with a relaxing spring, each with the place of its z in the extended state."""
    return [(contact, int(z)) for contact, z in enumerate(machine.relaxing_state) if z != NO_STATE]


def _base(mechanism: Mechanism, layout: MechanismLayout, rows: EndRows) -> Reals:
    count = len(layout.coordinates)
    base = np.zeros((layout.size, layout.size))
    base[:count, count : 2 * count] = np.eye(count)
    base[:count, -1] -= layout.frame.velocities
    if layout.frame.follows:
        base[:count, count + layout.frame.leading] -= layout.frame.directions
    if mechanism.structures:
        stiffness, damping = elastic_matrices(mechanism)
        base[count : 2 * count, :count] -= rows.accelerations(stiffness)
        base[count : 2 * count, count : 2 * count] -= rows.accelerations(damping)
    for link in mechanism.links.values():
        base[count : 2 * count] -= np.outer(rows.push(*link.between), rows.tension(link))
    for friction in mechanism.frictions.values():
        drag = friction.viscous * rows.speed(friction.between)
        base[count : 2 * count] -= np.outer(rows.push(*friction.between), drag)
    for force_on in mechanism.forces.values():
        push = rows.push(GROUND, force_on.on)
        base[count : 2 * count] += np.outer(push, rows.given(force_on))
    for order in layout.orders:
        sine = layout.sine(order)
        base[sine, sine + 1] = order * layout.omega
        base[sine + 1, sine] = -order * layout.omega
    for profile in layout.profiles:
        base[layout.profile(profile), layout.profile(profile) + 1] = 1.0
    if layout.ramp:
        base[-2, -1] = 1.0
    return base


def _contacts(contacts: Mapping[str, Play | Stop], layout: MechanismLayout, rows: EndRows) -> dict[str, Any]:
    count = len(contacts)
    parts = list(contacts.values())
    between = [part.between for part in parts]
    first = 2 * len(layout.coordinates)
    return {
        "contact_distance": _stacked(map(rows.distance, between), layout.size),
        "contact_rate": _stacked(map(rows.speed, between), layout.size),
        "contact_push": _stacked([-rows.push(*each) for each in between], len(layout.coordinates)),
        "stiffness": np.array([part.stiffness for part in parts], dtype=np.float64),
        "damping": np.array([part.damping for part in parts], dtype=np.float64),
        "offsets": np.array([_offsets(part) for part in parts], dtype=np.float64).reshape(count, 2),
        "law": np.array([PULLS if p.damping == 0 else _LAWS[p.law] for p in parts], dtype=np.int64),
        "relaxing_state": np.array(
            [
                first + layout.relaxing.index(name) if name in layout.relaxing else NO_STATE
                for name in contacts
            ],
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
    mechanism: Mechanism, frictions: Mapping[str, object], layout: MechanismLayout, rows: EndRows
) -> dict[str, Any]:
    parts = [mechanism.frictions[name] for name in frictions]
    between = [part.between for part in parts]
    return {
        "friction_rate": _stacked(map(rows.speed, between), layout.size),
        "friction_push": _stacked(starmap(rows.push, between), len(layout.coordinates)),
        "kinetic": np.array([part.kinetic_force for part in parts], dtype=np.float64),
        "static": np.array([part.static_force for part in parts], dtype=np.float64),
    }


def _walls(mechanism: Mechanism, layout: MechanismLayout, rows: EndRows) -> dict[str, Any]:
    walls = list(mechanism.walls.values())
    between = [wall.between for wall in walls]
    distances = list(map(rows.distance, between))
    for distance, wall in zip(distances, walls, strict=True):
        distance[-1] -= wall.gap
    return {
        "wall_distance": _stacked(distances, layout.size),
        "wall_rate": _stacked(map(rows.speed, between), layout.size),
        "wall_push": _stacked(starmap(rows.push, between), len(layout.coordinates)),
        "restitution": np.array([wall.restitution for wall in walls], dtype=np.float64),
    }


def _stacked(rows: Iterable[Reals], size: int) -> Reals:
    return np.array([*rows], dtype=np.float64).reshape(-1, size)
