"""Where the energy of a motion by brute force goes, part by part, by quadrature."""

from dataclasses import dataclass

import numpy as np

from tests.mechanisms.brute_force import BruteMotion, Piece, extend
from tests.mechanisms.measures import integral
from tests.mechanisms.waves import constant


@dataclass(frozen=True)
class Energy:
    """Energies of a whole motion, J."""

    change: float  # Of kinetic energy and of what springs of links and contacts hold
    supplied: float  # By forces and by what moves the pins
    links: dict[str, float]  # Lost in dampers of links, by name
    contacts: dict[str, float]  # Lost in plays and stops, by name
    frictions: dict[str, float]  # Lost in frictions, by name
    structures: float  # Lost in all structures

    @property
    def unbalance(self) -> float:
        """What is left over."""
        lost = (*self.links.values(), *self.contacts.values(), *self.frictions.values())
        return self.supplied - self.change - sum(lost) - self.structures


def energy(motion: BruteMotion) -> Energy:
    """Return the energies."""
    system = motion.system
    rows, mechanism = system.rows, system.mechanism

    def work(left, right) -> float:
        """Integrate a product of two rows, each given for a piece."""
        return float(integral(motion, lambda t, y, piece: (left(piece) @ y) * (right(piece) @ y)))

    links = {
        name: link.damping
        * work(lambda _, b=link.between: rows.rate(b), lambda _, b=link.between: rows.rate(b))
        for name, link in mechanism.links.items()
    }
    contacts, frictions = {}, {}
    for place, contact in enumerate(system.contacts):

        def tension(piece: Piece, contact=contact, place=place) -> np.ndarray:
            return contact.force(piece.mode.contacts[place])

        def rate(_: Piece, contact=contact) -> np.ndarray:
            return rows.rate(contact.part.between)

        contacts[contact.name] = work(tension, rate) - _stored_in(motion, place)
    for place, friction in enumerate(system.frictions):

        def rubbing(piece: Piece, place=place) -> np.ndarray:
            return -system.dynamics(piece.mode).friction_forces[place]

        frictions[friction.name] = work(rubbing, lambda _, friction=friction: friction.velocity)
    count, (_, damping, _) = len(rows.bodies), system.matrices

    def power(_times, y: np.ndarray, _piece: Piece) -> np.ndarray:
        return np.einsum("it,ij,jt->t", y[count : 2 * count], damping, y[count : 2 * count])

    lost = float(integral(motion, power))
    return Energy(_change(motion), _supplied(motion), links, contacts, frictions, lost)


def _ends(motion: BruteMotion) -> tuple[tuple[np.ndarray, Piece], tuple[np.ndarray, Piece]]:
    """The extended states at begin and end, each with a piece next to it."""
    first, last = motion.pieces[0], motion.pieces[-1]
    begun = first.interpolated(np.array([first.begin]))[:, 0]
    return (begun, first), (extend(motion.system, motion.final, last.end), last)


def _stored_in(motion: BruteMotion, place: int) -> float:
    """Change of the energy of a contact's spring."""
    contact = motion.system.contacts[place]
    (begun, first), (ended, last) = _ends(motion)
    return _spring(contact, first.mode.contacts[place], ended=begun, sign=-1) + _spring(
        contact, last.mode.contacts[place], ended=ended, sign=1
    )


def _spring(contact, mode, ended: np.ndarray, sign: int) -> float:
    if contact.has_state:
        stretch = contact.rows.z(contact.name)
    elif mode.touching:
        stretch = contact.beyond(mode.side)
    else:
        return 0.0
    return sign * contact.part.stiffness / 2 * float(stretch @ ended) ** 2


def _change(motion: BruteMotion) -> float:
    system, (begun, _), (ended, _) = motion.system, *_ends(motion)
    count = len(system.masses)

    def held(y: np.ndarray) -> float:
        springs = sum(
            link.stiffness / 2 * float(system.rows.distance(link.between) @ y) ** 2
            for link in system.mechanism.links.values()
        )
        (mass, _, stiffness), q, v = system.matrices, y[:count], y[count : 2 * count]
        return float(v @ mass @ v + q @ stiffness @ q) / 2 + springs

    stored = sum(_stored_in(motion, place) for place in range(len(system.contacts)))
    return held(ended) - held(begun) + stored


def _supplied(motion: BruteMotion) -> float:
    """Work of forces, and of the pins' motion relative to their bodies against the forces on the pins."""
    system, rows = motion.system, motion.system.rows
    count, clock = len(system.masses), rows.clock()

    def power(times, y, piece):
        total = np.zeros(len(times))
        for force in system.mechanism.forces.values():
            given = rows.constant(constant(force)) + rows.waves(force)
            total += (given @ y) * (rows.weights(force.on) @ y[count : 2 * count])
        for between, tension in _tensions(motion, piece):
            start, end = (rows.prescribed(name) @ clock for name in between)
            total += (tension @ y) * ((end - start) @ y)
        return total

    return float(integral(motion, power))


def _tensions(motion: BruteMotion, piece: Piece):
    """The ends of each part, and the force that pulls them together."""
    system, rows = motion.system, motion.system.rows
    for link in system.mechanism.links.values():
        stretch, rate = rows.distance(link.between), rows.rate(link.between)
        yield link.between, link.stiffness * stretch + link.damping * rate
    for contact, mode in zip(system.contacts, piece.mode.contacts, strict=True):
        yield contact.part.between, contact.force(mode)
    rubbing = system.dynamics(piece.mode).friction_forces
    for friction, force in zip(system.frictions, rubbing, strict=True):
        yield friction.part.between, -force
