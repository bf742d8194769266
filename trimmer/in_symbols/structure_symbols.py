"""What of structures has a symbol in printed equations: coordinates, entries of matrices, modes."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations_with_replacement
from types import MappingProxyType

import numpy as np

from trimmer.arrays import Reals
from trimmer.mechanism import Mechanism, Structure
from trimmer.mechanism.kinds import Kind

COORDINATE = "coordinate"  # Before the name of a coordinate
MATRICES = ("mass", "damping", "stiffness", "mobility")
"""Matrices whose entries have symbols; the last is the inverse of the first."""
FREQUENCY, DAMPING_RATIO = "natural frequency", "damping ratio"  # Before the number of a mode
_LETTERS: Mapping[str, str] = MappingProxyType(
    dict(zip((*MATRICES, FREQUENCY, DAMPING_RATIO), ("M", "C", "K", "W", "omega", "zeta"), strict=True))
)
_UNITS: Mapping[str, tuple[str, str, str]] = MappingProxyType(
    {
        "mass": ("kg", "kg m", "kg m²"),
        "damping": ("N s/m", "N s", "N m s/rad"),
        "stiffness": ("N/m", "N", "N m/rad"),
        "mobility": ("1/kg", "1/(kg m)", "1/(kg m²)"),
    }
)
"""Of an entry for two translations, one of each, two rotations."""
_WORDS: Mapping[str, str] = MappingProxyType({"mobility": "inverse mass"})


@dataclass(frozen=True)
class StructureSymbol:
    """Something of a structure that has a symbol."""

    of: str  # What it is, by which it is asked for
    letter: str  # Its letter
    index: str  # What follows the name of the structure in its index
    meaning: str  # What it is, in plain words
    unit: str  # Its SI unit
    value: float | None  # Its number; None for a function of time


def symbols_of(mechanism: Mechanism, name: str) -> Iterator[StructureSymbol]:
    """Yield what has a symbol of a structure, coordinates first; entries that are zero have none."""
    structure = mechanism.structures[name]
    for own in structure.names:
        full = f"{name}.{own}"
        turns = mechanism.kinds[full] is Kind.ROTATION
        unit = "rad" if turns else "m" if structure.modes is None else "m kg^1/2"
        word = "angle" if turns else "displacement"
        yield StructureSymbol(
            f"{COORDINATE} {own}", "theta" if turns else "q", f".{own}", f"{word} of {full}", unit, None
        )
    yield from _of_matrices(name, structure) if structure.modes is None else _of_modes(name, structure)


def matrices_of(structure: Structure) -> dict[str, Reals]:
    """Return the matrices whose entries have symbols."""
    mass, damping, stiffness = structure.matrices
    inverse = np.linalg.inv(mass)
    return dict(zip(MATRICES, (mass, damping, stiffness, 0.5 * (inverse + inverse.T)), strict=True))


def entry_of(matrix: str, row: int, column: int) -> str:
    """Return by what an entry of a symmetric matrix is asked for, from 0 on."""
    first, second = sorted((row, column))
    return f"{matrix} {first + 1},{second + 1}"


def shape_of(point: str, mode: int) -> str:
    """Return by what the shape of a mode at a point is asked for, from 0 on."""
    return f"shape {mode + 1} at {point}"


def _of_matrices(name: str, structure: Structure) -> Iterator[StructureSymbol]:
    turning = [own in structure.rotations for own in structure.names]
    for kind, matrix in matrices_of(structure).items():
        for row, column in combinations_with_replacement(range(len(matrix)), 2):
            if matrix[row, column] != 0.0:
                place = f"{row + 1},{column + 1}"
                unit = _UNITS[kind][turning[row] + turning[column]]
                meaning = f"entry {place} of the {_WORDS.get(kind, kind)} matrix of {name}"
                value = float(matrix[row, column])
                yield StructureSymbol(
                    entry_of(kind, row, column), _LETTERS[kind], f",{place}", meaning, unit, value
                )


def _of_modes(name: str, structure: Structure) -> Iterator[StructureSymbol]:
    assert structure.modes is not None
    model = structure.modes
    numbers = ((FREQUENCY, 2 * np.pi * model.frequency, "rad/s"), (DAMPING_RATIO, model.damping_ratio, "1"))
    for kind, values, unit in numbers:
        for mode, value in enumerate(values.tolist(), 1):
            meaning = f"{kind} of mode {mode} of {name}"
            yield StructureSymbol(f"{kind} {mode}", _LETTERS[kind], f",{mode}", meaning, unit, value)
    for point, shape in model.shapes.items():
        yield StructureSymbol(
            f"point {point}", "p", f".{point}", f"displacement of {name}.{point}", "m", None
        )
        for mode, value in enumerate(shape.tolist()):
            meaning = f"shape of mode {mode + 1} at {name}.{point}"
            of = shape_of(point, mode)
            yield StructureSymbol(of, "phi", f".{point},{mode + 1}", meaning, "kg^-1/2", value)
