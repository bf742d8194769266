"""What is known of all motions of a mechanism: whether they have mirror images, stay bounded, are damped."""

from __future__ import annotations

import numpy as np

from trimmer.arrays import ROUNDING, Complexes, Reals
from trimmer.contact.machine.machine import Machine
from trimmer.contact.modes.curves import add_least_curves
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.references import references_in
from trimmer.hybrid.system import ModeEquations
from trimmer.mechanism import Mechanism, SineReference
from trimmer.mechanism.coordinates import inertia_of
from trimmer.mechanism.waves import mean_of

NEGLIGIBLE = 1e-9
"""Share of the largest velocity of a motion, or eigenvalue of a matrix, below which another may be none."""


def is_mirror_symmetric(mechanism: Mechanism, layout: MechanismLayout, period: float) -> bool:
    """Say whether x(t) and -x(t + T/2) are motions alike; see ``Flow.is_mirror_symmetric``."""
    odd = all(order % 2 == 1 for order in layout.orders)
    centred = all(mean_of(pin) == 0 and pin.velocity == 0 for pin in mechanism.pins.values())
    pushed = any(mean_of(force) != 0 for force in mechanism.forces.values()) or not all(
        link.is_odd for link in mechanism.links.values()
    )
    constant = any(not isinstance(each, SineReference) for each in references_in(mechanism))
    return (
        bool(period)
        and not constant
        and odd
        and centred
        and not pushed
        and not mechanism.stops
        and not mechanism.walls
    )


def is_bounded(mechanism: Mechanism, machine: Machine) -> bool:
    """Say whether links hold and damp every displacement, so that no motion can grow for ever."""
    if any(pin.velocity for pin in mechanism.pins.values()) or mechanism.controllers:
        return False
    return all(
        values[0] > NEGLIGIBLE * abs(values[-1])
        for values in (_resistance(mechanism, machine, of_rates=each) for each in (False, True))
    )


def only_loses_energy(mechanism: Mechanism, machine: Machine) -> bool:
    """Say whether nothing brings energy into a motion, and something takes it away.

    Such a motion comes to rest, or slows down for ever; it neither repeats nor is chaotic in the end.
    """
    fed = mechanism.frequency is not None or mechanism.drives or mechanism.controllers
    if fed or any(pin.velocity for pin in mechanism.pins.values()):
        return False
    resistance = _resistance(mechanism, machine, of_rates=True)
    rubs = len(machine.kinetic) or machine.curve_by_speed.any()
    takes = resistance[-1] > 0 or machine.damping.any() or rubs or (machine.restitution < 1.0).any()
    return bool(takes and resistance[0] >= -NEGLIGIBLE * abs(resistance[-1]))


def _resistance(mechanism: Mechanism, machine: Machine, *, of_rates: bool) -> Reals:
    """Return the eigenvalues of stiffness or damping relative to the mass, rising: of L⁻¹ K L⁻ᵀ, M = L Lᵀ."""
    factor = np.linalg.cholesky(inertia_of(mechanism).matrix)
    count, base = len(factor), machine.base.copy()
    add_least_curves(machine, base)
    block = slice(count, 2 * count) if of_rates else slice(0, count)
    resisting = -np.linalg.solve(factor, (factor.T @ base[count : 2 * count, block]).T)
    values: Reals = np.linalg.eigvalsh(0.5 * (resisting + resisting.T)).astype(np.float64)
    return values


def damping(
    mechanism: Mechanism, mode: ModeEquations, states: Complexes, rates: Complexes, margins: Reals
) -> Reals:
    """Return the real parts of eigenvalues, exactly zero where nothing damps or rounding cannot tell."""
    if mechanism.controllers:
        return np.where(abs(rates.real) <= margins, 0.0, rates.real)
    mass = inertia_of(mechanism).matrix
    velocities = slice(len(mass), 2 * len(mass))
    moved = states[velocities]  # Velocities of a free part are λ times its displacements.
    resisting = -mass @ mode.flow[velocities, velocities]
    inertia = (moved.conj() * (mass @ moved)).real.sum(axis=0)
    real: Reals = rates.real.copy()
    for each in np.flatnonzero((rates.imag != 0) & (inertia > 0)):
        column = moved[:, each]
        work = float((column.conj() @ resisting @ column).real)
        rounding = ROUNDING * float(abs(column) @ abs(resisting) @ abs(column))
        real[each] = -0.5 * work / inertia[each] if abs(work) > rounding else 0.0
    real[(rates.imag == 0) & (abs(rates.real) <= margins)] = 0.0
    return real
