"""The matrices of the linear part of a mechanism."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.mechanism.coordinates import Inertia, elastic_matrices, inertia_of, weights_of_ends
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND
from trimmer.showing.shown import Shown, counted


@dataclass(frozen=True, eq=False, repr=False)
class LinearMatrices(Shown):
    """Matrices of M q'' + C q' + K q = P_u u + P_v u' + F f, in this order.

    q are the coordinates in the fixed frame, u those of the pins relative to their carriers,
    f the forces, each in the order of the mechanism.

    Attributes:
        mass: (coordinates, coordinates), kg.
        damping: (coordinates, coordinates), N s/m.
        stiffness: (coordinates, coordinates), N/m.
        pin_displacement: (coordinates, pins), N/m.
        pin_velocity: (coordinates, pins), N s/m.
        forces: (coordinates, forces), 1 where a force acts on a body.
    """

    mass: Reals
    damping: Reals
    stiffness: Reals
    pin_displacement: Reals
    pin_velocity: Reals
    forces: Reals

    @property
    def state_matrix(self) -> Reals:
        """A of x' = A x, x = (q, q'), without pins and forces, (2 coordinates, 2 coordinates)."""
        stiffness, damping = map(Inertia(self.mass).accelerations, (self.stiffness, self.damping))
        return np.block([[np.zeros_like(self.mass), np.eye(len(self.mass))], [-stiffness, -damping]])

    def _told(self) -> str:
        sizes = (len(self.mass), self.pin_displacement.shape[1], self.forces.shape[1])
        return ", ".join(map(counted, sizes, ("body", "pin", "force")))


def linear_matrices(mechanism: Mechanism, *, viscous: bool = False) -> LinearMatrices:
    """Assemble the matrices of bodies, structures and links; plays, stops and dry friction are left out.

    Args:
        mechanism: The mechanism.
        viscous: Take the viscous coefficients of frictions as dampers.

    Raises:
        WrongTypeError: if no mechanism is given.
    """
    require_instance("mechanism", mechanism, Mechanism, "a trimmer.Mechanism")
    rows = displacement_rows(mechanism)
    couplings = [(link.between, link.stiffness_at_rest, link.damping) for link in mechanism.links.values()]
    if viscous:
        couplings += [(each.between, 0.0, each.viscous) for each in mechanism.frictions.values()]
    coordinates = len(mechanism.coordinates)
    stiffness, damping = (np.zeros((coordinates, len(rows[GROUND]))) for _ in range(2))
    stiffness[:, :coordinates], damping[:, :coordinates] = elastic_matrices(mechanism)
    for (start, end), k, c in couplings:
        elongation = rows[end] - rows[start]
        pulled = elongation[:coordinates]
        stiffness += k * np.outer(pulled, elongation)
        damping += c * np.outer(pulled, elongation)
    return LinearMatrices(
        inertia_of(mechanism).matrix,
        damping[:, :coordinates],
        stiffness[:, :coordinates],
        -stiffness[:, coordinates:],
        -damping[:, coordinates:],
        np.array([rows[force.on][:coordinates] for force in mechanism.forces.values()])
        .reshape(-1, coordinates)
        .T,
    )


def displacement_rows(mechanism: Mechanism) -> Mapping[str, Reals]:
    """Return the displacement of every end as a row of factors, (coordinates + pins).

    They are of the coordinates in the fixed frame, then of the pins relative to their carriers.
    """
    pins = dict(zip(mechanism.pins, np.eye(len(mechanism.pins)), strict=True))
    beside = np.zeros(len(pins))
    return {
        name: np.concatenate([weights, pins.get(name, beside)])
        for name, weights in weights_of_ends(mechanism).items()
    }
