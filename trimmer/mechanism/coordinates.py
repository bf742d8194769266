"""What a mechanism moves by: its coordinates, what each end weighs them with, and their mass.

The displacement of an end is the sum of the coordinates times its weights, beside what is prescribed of it.
By virtual work, a force F on it acts on each coordinate with F times the weight.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.kept_property import cached_property
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import WEIGHTS, Mechanism
from trimmer.mechanism.structures.ends import weights_in
from trimmer.mechanism.structures.structure import Structure


def weights_of_ends(mechanism: Mechanism) -> Mapping[str, Reals]:
    """Return by name what weighs the coordinates in the displacement of each end, (coordinates,).

    It is kept in the mechanism, and in those that differ from it by another number than a point's.
    """
    kept: dict[str, Mapping[str, Reals]] = vars(mechanism)
    if WEIGHTS not in kept:
        places = {name: place for place, name in enumerate(mechanism.coordinates)}
        found = {}
        for name, weights in weights_in(vars(mechanism)).items():
            found[name] = np.zeros(len(places))
            found[name][[places[of] for of in weights]] = list(weights.values())
            found[name].setflags(write=False)
        kept[WEIGHTS] = found
    return kept[WEIGHTS]


def shaken_ends(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the ends whose accelerations are told: the coordinates, and in place of modes their points."""
    structures = mechanism.structures.items()
    return (
        *mechanism.bodies,
        *(f"{name}.{own}" for name, each in structures for own in (each.points or each.names)),
    )


def inertia_of(mechanism: Mechanism) -> Inertia:
    """Return the mass matrix of the coordinates."""
    mass = np.zeros((len(mechanism.coordinates),) * 2)
    bodies = range(len(mechanism.bodies))
    mass[bodies, bodies] = [body.generalised_mass for body in mechanism.bodies.values()]
    for structure, rows in rows_of_structures(mechanism):
        mass[rows, rows] = structure.matrices[0]
    return Inertia(mass)


def rows_of_structures(mechanism: Mechanism) -> Iterator[tuple[Structure, slice]]:
    """Yield each structure with the places of its coordinates among all, in order."""
    first = len(mechanism.bodies)
    for structure in mechanism.structures.values():
        yield structure, slice(first, first + len(structure.names))
        first += len(structure.names)


def elastic_matrices(mechanism: Mechanism) -> tuple[Reals, Reals]:
    """Return stiffness and damping of the structures among all coordinates, (n, n) each."""
    stiffness, damping = (np.zeros((len(mechanism.coordinates),) * 2) for _ in range(2))
    for structure, rows in rows_of_structures(mechanism):
        _, damping[rows, rows], stiffness[rows, rows] = structure.matrices
    return stiffness, damping


def radius_of(mechanism: Mechanism) -> float:
    """Return the length, m, by which angles are compared with displacements: a radius of gyration.

    It is the root of the mean inertia over the mean mass; 1 where all turns, or nothing does. So what is much
    smaller than all else does not depend on whether a body is written as an inertia or as its mass at an arm.
    """
    turns = np.array([mechanism.kinds[name] is Kind.ROTATION for name in mechanism.coordinates])
    if turns.all() or not turns.any():
        return 1.0
    masses = inertia_of(mechanism).matrix.diagonal()
    return float(np.sqrt(masses[turns].mean() / masses[~turns].mean()))


@dataclass(frozen=True, eq=False)
class Inertia:
    """The mass matrix M of n coordinates, symmetric and positive definite, (n, n)."""

    matrix: Reals

    @cached_property
    def _coupled(self) -> tuple[Flags, Reals] | None:
        """The coordinates whose accelerations depend on forces on others, (n,), and the inverse of theirs."""
        off = self.matrix != 0.0
        np.fill_diagonal(off, False)
        coupled = off.any(axis=1)
        if not coupled.any():
            return None
        inverse = np.linalg.inv(self.matrix[np.ix_(coupled, coupled)])
        return coupled, 0.5 * (inverse + inverse.T)

    def accelerations(self, forces: Reals) -> Reals:
        """Return M⁻¹ times forces, (n,) or (n, columns)."""
        found: Reals = (forces.T / self.matrix.diagonal()).T
        if self._coupled is not None:
            coupled, inverse = self._coupled
            found[coupled] = inverse @ forces[coupled]
        return found
