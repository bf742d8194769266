"""Modes and transfer functions of a mechanism with its contacts open, and with all of them closed.

Dry friction is left out; its viscous share is a damper. A closed contact is a link at its middle.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.mechanism import LinearMatrices, Mechanism, linear_matrices
from trimmer.mechanism.coordinates import shaken_ends, weights_of_ends
from trimmer.mechanism.drives import waves_in
from trimmer.mechanism.linear.outputs import Contacts, output_rows, with_contacts

POINTS = 2000  # Frequencies of a transfer function
BELOW, ABOVE = 20.0, 3.0
"""Ends of a transfer function: how far below the lowest frequency of interest, and above the highest."""
RIGID = 1e-6  # Modulus of an eigenvalue, relative to the largest, below which it counts as zero


@dataclass(frozen=True, eq=False)
class LinearMode:
    """An oscillating mode of the linear mechanism.

    Attributes:
        frequency: Of the oscillation as it dies out, imaginary part of the eigenvalue / 2 pi, Hz.
        damping_ratio: Share of critical damping.
        shape: Displacement of each body or point, scaled so that the largest is 1, complex, (bodies,).
    """

    frequency: float
    damping_ratio: float
    shape: Complexes


@dataclass(frozen=True, eq=False)
class TransferFunction:
    """What an output does for each unit of a drive, over frequency.

    Attributes:
        drive: Name of the pin or force.
        unit: SI unit of the drive.
        output: Name of the output.
        frequency: Hz, (n,).
        response: Output per unit of the drive, (n,).
        at_drive: The same at the frequency of that drive; None without a drive.
        output_unit: SI unit of the output.
    """

    drive: str
    unit: str
    output: str
    frequency: Reals
    response: Complexes
    at_drive: complex | None
    output_unit: str = "m"

    @property
    def per_unit(self) -> str:
        """SI unit of the response; empty for a number."""
        drive = f"({self.unit})" if " " in self.unit else self.unit
        return "" if self.unit == self.output_unit else f"{self.output_unit}/{drive}"


@dataclass(frozen=True, eq=False)
class LinearState:
    """The linear mechanism with its contacts in one state.

    Attributes:
        contacts: That state; closed if some are.
        bodies: Names of bodies, and of points in place of modes, in the order of the shapes.
        modes: By rising frequency.
        rigid: Number of motions that no spring resists.
        decaying: Number of motions that only decay.
        transfer: Of each drive to each output.
        open: Names of the contacts that are open.
    """

    contacts: Contacts
    bodies: tuple[str, ...]
    modes: tuple[LinearMode, ...]
    rigid: int
    decaying: int
    transfer: tuple[TransferFunction, ...]
    open: tuple[str, ...] = ()


def linear_states(
    mechanism: Mechanism, drives: Sequence[tuple[str, str, float]] | None = None
) -> tuple[LinearState, ...]:
    """Return the linear mechanism with its contacts closed, then open; once if it has none.

    Drives are name, SI unit and order of pins and forces whose responses are wanted; those that vibrate
    if not given.
    """
    contacts = (*mechanism.plays.values(), *mechanism.stops.values())
    any_pushes = any(each.stiffness or each.damping for each in contacts)
    states = (Contacts.CLOSED, Contacts.OPEN) if any_pushes else (Contacts.CLOSED,)
    return tuple(linear_state(mechanism, each, drives) for each in states)


def linear_state(
    mechanism: Mechanism,
    contacts: Contacts | str | Mapping[str, Contacts | str],
    drives: Sequence[tuple[str, str, float]] | None = None,
) -> LinearState:
    """Return the linear mechanism with its contacts in one state, as ``Mechanism.state_space`` takes them."""
    taken = with_contacts(mechanism, contacts)
    left = (*taken.plays, *taken.stops)
    all_open = bool(left) and len(left) == len(mechanism.plays) + len(mechanism.stops)
    return _state(
        taken,
        Contacts.OPEN if all_open else Contacts.CLOSED,
        left,
        driving(mechanism) if drives is None else drives,
    )


def _state(
    mechanism: Mechanism, contacts: Contacts, left: tuple[str, ...], drives: Sequence[tuple[str, str, float]]
) -> LinearState:
    matrices = linear_matrices(mechanism, viscous=True)
    values, vectors = np.linalg.eig(matrices.state_matrix)
    size = abs(values).max()
    rigid = abs(values) <= RIGID * size
    swinging = np.flatnonzero((values.imag > RIGID * size) & ~rigid)
    ends, weights = shaken_ends(mechanism), weights_of_ends(mechanism)
    shapes = np.array([weights[end] for end in ends]) @ vectors[: len(mechanism.coordinates)]
    modes = sorted((_mode(values[at], shapes[:, at]) for at in swinging), key=lambda mode: mode.frequency)
    return LinearState(
        contacts,
        ends,
        tuple(modes),
        int(rigid.sum() + 1) // 2,
        int(len(values) - rigid.sum() - 2 * len(swinging)),
        tuple(_transfer(mechanism, matrices, [mode.frequency for mode in modes], drives)),
        left,
    )


def _mode(value: complex, vector: Complexes) -> LinearMode:
    largest = vector[np.argmax(abs(vector))]
    shape = vector / largest if largest else vector
    return LinearMode(float(value.imag) / (2 * np.pi), float(-value.real / abs(value)), shape)


def _transfer(
    mechanism: Mechanism,
    matrices: LinearMatrices,
    modes: list[float],
    drives: Sequence[tuple[str, str, float]],
) -> Iterator[TransferFunction]:
    marks = [*modes, *([mechanism.frequency] if mechanism.frequency else [])]
    if not marks:
        return
    frequency = np.geomspace(min(marks) / BELOW, max(marks) * ABOVE, POINTS)
    for drive, unit, order in drives:
        response = _responses(mechanism, matrices, drive, frequency)
        own = None if mechanism.frequency is None else np.array([order * mechanism.frequency])
        there = {} if own is None else _responses(mechanism, matrices, drive, own)
        for name, values in response.items():
            at_drive = complex(there[name][0]) if there else None
            of = mechanism.output_units[name]
            yield TransferFunction(drive, unit, name, frequency, values, at_drive, of)


def all_drives(mechanism: Mechanism) -> list[tuple[str, str, float]]:
    """Return name, SI unit and order of all pins and forces."""
    forces = {name: each for name, each in mechanism.forces.items() if name not in mechanism.pins}
    return [
        *((name, _unit(mechanism, name), pin.order) for name, pin in mechanism.pins.items()),
        *((name, _unit(mechanism, name), force.order) for name, force in forces.items()),
    ]


def driving(mechanism: Mechanism) -> list[tuple[str, str, float]]:
    """Return name, SI unit and order of the pins and forces that vibrate."""
    waves = [
        *((name, waves_in(mechanism, pin)) for name, pin in mechanism.pins.items()),
        *((name, waves_in(mechanism, force)) for name, force in mechanism.forces.items()),
    ]
    return [(name, _unit(mechanism, name), found[0].order) for name, found in waves if found]


def _unit(mechanism: Mechanism, drive: str) -> str:
    """Return the SI unit of a pin or a force."""
    section, unit = ("pins", "m") if drive in mechanism.pins else ("forces", "N")
    return mechanism.kind_of(section, drive).unit(unit)


def _responses(
    mechanism: Mechanism, matrices: LinearMatrices, drive: str, frequency: Reals
) -> dict[str, Complexes]:
    """Return what each output does for a unit of a drive, m per unit, (n,)."""
    bodies = len(mechanism.coordinates)
    s = 2j * np.pi * frequency
    dynamic = s[:, None, None] ** 2 * matrices.mass + s[:, None, None] * matrices.damping + matrices.stiffness
    own = np.zeros(len(mechanism.pins))
    if drive in mechanism.pins:
        column = list(mechanism.pins).index(drive)
        own[column] = 1.0
        push = matrices.pin_displacement[:, column] + s[:, None] * matrices.pin_velocity[:, column]
    else:
        column = list(mechanism.forces).index(drive)
        push = np.broadcast_to(matrices.forces[:, column], (len(s), bodies)).astype(complex)
    moved = np.linalg.solve(dynamic, push[:, :, None])[:, :, 0]
    moved = np.concatenate([moved, np.broadcast_to(own, (len(s), len(own)))], axis=1)
    rates = s[:, None] ** np.arange(3)
    return {
        name: np.einsum("fi,fk,ki->f", moved, rates, factors, optimize=True)
        for name, factors in output_rows(mechanism).items()
    }
