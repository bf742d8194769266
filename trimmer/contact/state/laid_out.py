"""The layout of the extended state that a mechanism asks for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.controllers.held import held_by
from trimmer.contact.controllers.laws import laws_of
from trimmer.contact.state.frame import SAME, Frame, frame_of, leans
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.profiles import Profile
from trimmer.contact.state.references import profile_of, references_in
from trimmer.contact.state.rows import EndRows
from trimmer.mechanism.coordinates import radius_of, shaken_ends, weights_of_ends
from trimmer.mechanism.drives import drive_frequency, drives_of, sines_in, waves_in, waves_of_sine
from trimmer.mechanism.kinds import Kind, kind_of_part
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import ContactLaw, Force, Pin, Play, Stop


def layout_of(
    mechanism: Mechanism,
    contacts: Mapping[str, Play | Stop],
    frictions: tuple[str, ...],
    frame: Frame | None = None,
) -> MechanismLayout:
    """Return the layout of a mechanism with some contacts and frictions that exert forces.

    Args:
        mechanism: The mechanism.
        contacts: Its plays and stops that exert forces.
        frictions: Names of its frictions that do.
        frame: In which displacements are; that of the ground if not given.
    """
    frame = frame_of(mechanism).fixed() if frame is None else frame
    omega = 2 * np.pi * (drive_frequency(mechanism) or 0.0)
    moved: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    waves = [wave for part in moved for wave in waves_in(mechanism, part)]
    waves += [wave for name in sines_in(mechanism) for wave in waves_of_sine(mechanism, name)]
    orders = sorted({wave.order for wave in waves})
    speeds = {name: float(each @ frame.velocities) for name, each in weights_of_ends(mechanism).items()}
    for name, pin in mechanism.pins.items():
        speeds[name] += pin.velocity
    ramp = any(
        abs(speeds[part.between[1]] - speeds[part.between[0]]) > SAME * max(map(abs, speeds.values()))
        for part in (*mechanism.links.values(), *contacts.values(), *mechanism.walls.values())
        if leans(part)
    )
    relaxing = tuple(
        name for name, part in contacts.items() if part.law is ContactLaw.RELAXING and part.damping > 0
    )
    laws = laws_of(mechanism)
    layout = MechanismLayout(
        mechanism.coordinates,
        tuple(contacts),
        frictions,
        curves_of(mechanism),
        tuple(mechanism.walls),
        relaxing,
        tuple(laws),
        tuple((name, state) for name, law in laws.items() for state in law.names),
        {},
        tuple(orders),
        drives_of(mechanism),
        tuple(dict.fromkeys(_profiles(mechanism, frame))),
        ramp,
        omega,
        tuple(speeds),
        np.array([]),
        shaken_ends(mechanism),
        frame,
        dict.fromkeys(speeds, 0.0) if ramp else speeds,
        np.array([]),
    )
    if held := held_by(mechanism.controllers, layout.state_count):
        layout = replace(layout, held=held)
    end_rows = EndRows(mechanism, layout).displacements()
    return replace(layout, lengths=_lengths(mechanism, contacts, layout), end_rows=end_rows)


def curves_of(mechanism: Mechanism) -> tuple[tuple[str, str], ...]:
    """Return section and name of the parts of a mechanism that have a curve."""
    found = ((section, getattr(mechanism, section)) for section in ("links", "frictions"))
    return tuple((section, name) for section, parts in found for name, part in parts.items() if part.curve)


def _profiles(mechanism: Mechanism, frame: Frame) -> Iterator[Profile]:
    """Yield what forces the states by times."""
    yield from (Profile(force.profile) for force in mechanism.forces.values() if force.profile)
    yield from (found for each in references_in(mechanism) if (found := profile_of(each, frame)) is not None)


def _lengths(mechanism: Mechanism, contacts: Mapping[str, Play | Stop], layout: MechanismLayout) -> Reals:
    radius, kinds = radius_of(mechanism), mechanism.kinds
    of = {kind: radius if kind is Kind.ROTATION else 1.0 for kind in Kind}
    coordinates = [of[kinds[name]] for name in mechanism.coordinates]
    springs = [of[kind_of_part(kinds, "plays", name, contacts[name])] for name in layout.relaxing]
    return np.array(
        [
            *coordinates,
            *coordinates,
            *springs,
            *(1.0 for _ in range(layout.first_control, layout.state_count)),
        ]
    )
