"""The matrices of the linear part of a mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND
from trimmer.showing.shown import Shown, counted


@dataclass(frozen=True, eq=False, repr=False)
class LinearMatrices(Shown):
    """Matrices of M q'' + C q' + K q = P_u u + P_v u' + F f, in this order.

    q are the displacements of the bodies in the fixed frame, u those of the pins relative to their carriers,
    f the forces, each in the order of the mechanism.

    Attributes:
        mass: (bodies, bodies), kg.
        damping: (bodies, bodies), N s/m.
        stiffness: (bodies, bodies), N/m.
        pin_displacement: (bodies, pins), N/m.
        pin_velocity: (bodies, pins), N s/m.
        forces: (bodies, forces), 1 where a force acts on a body.
    """

    mass: Reals
    damping: Reals
    stiffness: Reals
    pin_displacement: Reals
    pin_velocity: Reals
    forces: Reals

    def _told(self) -> str:
        sizes = (len(self.mass), self.pin_displacement.shape[1], self.forces.shape[1])
        return ", ".join(map(counted, sizes, ("body", "pin", "force")))


def linear_matrices(mechanism: Mechanism, *, viscous: bool = False) -> LinearMatrices:
    """Assemble the matrices of bodies and links; plays, stops and dry friction are left out.

    Args:
        mechanism: The mechanism.
        viscous: Take the viscous coefficients of frictions as dampers.

    Raises:
        WrongTypeError: if no mechanism is given.
    """
    require_instance("mechanism", mechanism, Mechanism, "a trimmer.Mechanism")
    rows = displacement_rows(mechanism)
    couplings = [(link.between, link.stiffness, link.damping) for link in mechanism.links.values()]
    if viscous:
        couplings += [(each.between, 0.0, each.viscous) for each in mechanism.frictions.values()]
    stiffness, damping = (np.zeros((len(mechanism.bodies), len(rows[GROUND]))) for _ in range(2))
    for (start, end), k, c in couplings:
        elongation = rows[end] - rows[start]
        pulled = elongation[: len(mechanism.bodies)]
        stiffness += k * np.outer(pulled, elongation)
        damping += c * np.outer(pulled, elongation)
    bodies = len(mechanism.bodies)
    return LinearMatrices(
        np.diag([body.mass for body in mechanism.bodies.values()]),
        damping[:, :bodies],
        stiffness[:, :bodies],
        -stiffness[:, bodies:],
        -damping[:, bodies:],
        np.array([rows[force.on][:bodies] for force in mechanism.forces.values()]).reshape(-1, bodies).T,
    )


def displacement_rows(mechanism: Mechanism) -> Mapping[str, Reals]:
    """Return the displacement of every body, pin and of the ground as a row of factors.

    Returns:
        By name, the factors (bodies + pins) of the displacements of the bodies in the fixed frame, then of
        those of the pins relative to their carriers, in the order of the mechanism.
    """
    bodies, pins = list(mechanism.bodies), mechanism.pins
    unit = np.eye(len(bodies) + len(pins))
    rows = {GROUND: np.zeros(len(unit))} | dict(zip(bodies, unit, strict=False))
    return rows | {
        name: rows[pin.on] + unit[len(bodies) + place] for place, (name, pin) in enumerate(pins.items())
    }
