"""Whether a structure's matrices or modes can be those of a linear part, and its names go with them."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.mechanism.problems import NOTHING, Problem, no_such
from trimmer.mechanism.structures.structure import LETTERS, MATRICES, ModalModel, Structure

SYMMETRIC = 1e-9  # Largest difference of two entries that should be equal, as a share of the largest entry
NEGATIVE = 1e-9
"""Modulus of a negative eigenvalue of a stiffness, as a share of the largest one, that is rounding."""
SINGULAR = 1e-13  # Least eigenvalue of a mass with ones on its diagonal that is not rounding
Place = tuple[str, ...]


def problems_of_structure(place: Place, structure: Structure) -> Iterator[Problem]:
    """Find what is wrong with a structure by itself."""
    if structure.modes is not None:
        others = (*MATRICES, "damping_ratio", "coordinates", "rotations")
        for key in others:
            given = getattr(structure, key)
            if isinstance(given, np.ndarray) or given not in (None, ()):
                reason = "the modes say it already; give either modes, or mass and stiffness"
                yield Problem((*place, key), reason, _shown(structure, key))
        yield from _modes(place, structure)
        return
    missing = [key for key in ("mass", "stiffness") if getattr(structure, key) is None]
    if len(missing) == 2:
        reason = 'missing; give mass = "M.mtx" and stiffness = "K.mtx", or modes = "modes.csv"'
        yield Problem((*place, "mass"), reason)
        return
    for key in missing:
        yield Problem((*place, key), f'missing; add {key} = "{LETTERS[key]}.mtx"')
    if structure.damping is not None and structure.damping_ratio is not None:
        reason = "there is a damping matrix too; give one of both"
        yield Problem((*place, "damping_ratio"), reason, structure.damping_ratio)
    matrices = {key: value for key in MATRICES if (value := getattr(structure, key)) is not None}
    wrong = {key: reason for key, value in matrices.items() if (reason := _reason_against(value))}
    for key, reason in wrong.items():
        yield Problem((*place, key), reason, _shown(structure, key))
    if not wrong and not missing:
        yield from _together(place, structure, {key: np.asarray(each) for key, each in matrices.items()})


def _shown(structure: Structure, key: str) -> object:
    value = getattr(structure, key)
    return structure.files.get(key, NOTHING if isinstance(value, np.ndarray) or key in MATRICES else value)


def _reason_against(value: object) -> str:
    """Return why a value is no real, symmetric matrix; empty if it is one."""
    try:
        matrix = np.asarray(value)
    except ValueError:
        return "must be a matrix, with rows of one length"
    if matrix.dtype.kind == "c":
        return "must be real; a complex stiffness stands for a loss factor, which is no linear part in time"
    if matrix.dtype.kind not in "fiu":
        return "must be a matrix of numbers"
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not len(matrix):
        return f"must be square; its shape is {' x '.join(map(str, matrix.shape))}"
    if not np.isfinite(matrix).all():
        return "must be finite"
    apart = abs(matrix - matrix.T)
    if apart.max() > SYMMETRIC * abs(matrix).max():
        row, column = (int(each) + 1 for each in np.unravel_index(apart.argmax(), apart.shape))
        here, there = float(matrix[row - 1, column - 1]), float(matrix[column - 1, row - 1])
        return f"must be symmetric; it holds {here!r} in row {row}, column {column}, and {there!r} opposite"
    return ""


def _together(place: Place, structure: Structure, matrices: Mapping[str, Reals]) -> Iterator[Problem]:
    count = len(matrices["mass"])
    for key, matrix in matrices.items():
        if len(matrix) != count:
            reason = f"has {len(matrix)} rows, and the mass matrix {count}; both are of the same coordinates"
            yield Problem((*place, key), reason, _shown(structure, key))
    size = np.sqrt(abs(matrices["mass"].diagonal()))
    size[size == 0.0] = 1.0
    if (least := float(np.linalg.eigvalsh(matrices["mass"] / np.outer(size, size))[0])) <= SINGULAR:
        reason = (
            "must be positive definite; there is a direction in which nothing has mass"
            if abs(least) <= SINGULAR
            else "must be positive definite; it has a negative eigenvalue"
        )
        reason += ": give every coordinate a mass, or reduce the model to those that have one"
        yield Problem((*place, "mass"), reason, _shown(structure, "mass"))
    values = np.linalg.eigvalsh(matrices["stiffness"])
    if values[0] < -NEGATIVE * abs(values).max():
        reason = f"must not push away; its eigenvalue {float(values[0])!r} is negative"
        yield Problem((*place, "stiffness"), reason, _shown(structure, "stiffness"))
    yield from _names(place, structure, count)


def _names(place: Place, structure: Structure, count: int) -> Iterator[Problem]:
    names, there = structure.coordinates, (*place, "coordinates")
    if not _are_names(names):
        yield Problem(there, 'name each coordinate, as in ["u1", "u2"]', names)
    elif not names:
        yield Problem(there, f"missing; name the {count} rows of the matrices, as in {_example(count)}")
    elif len(names) != count:
        given = f"{len(names)} name{'' if len(names) == 1 else 's'}"
        reason = f"holds {given} for the {count} rows of the matrices; name each row once"
        yield Problem(there, reason, list(names))
    elif len(set(names)) < count:
        again = next(name for name in names if list(names).count(name) > 1)
        yield Problem(
            there, f"{again!r} is there more than once; give each row a name of its own", list(names)
        )
    elif not _are_names(structure.rotations):
        yield Problem((*place, "rotations"), "name those coordinates that are angles", structure.rotations)
    else:
        for name in structure.rotations:
            if name not in names:
                reason = no_such("coordinate", name, names)
                yield Problem((*place, "rotations"), reason, list(structure.rotations))


def _are_names(names: Any) -> bool:
    return (
        isinstance(names, Sequence)
        and not isinstance(names, str)
        and all(isinstance(each, str) and each.isprintable() and each == each.strip() != "" for each in names)
    )


def _example(count: int) -> str:
    names = [f'"u{number}"' for number in range(1, min(count, 3) + 1)]
    return f"coordinates = [{', '.join([*names, *(['...'] if count > 3 else [])])}]"


def _modes(place: Place, structure: Structure) -> Iterator[Problem]:
    there, modes = (*place, "modes"), structure.modes
    shown = structure.files.get("modes", NOTHING)
    if not isinstance(modes, ModalModel) or not isinstance(modes.shapes, Mapping):
        yield Problem(there, "give a trimmer.mechanism.ModalModel, with a mapping of shapes", shown)
        return
    columns = {"frequency": modes.frequency, "damping_ratio": modes.damping_ratio, **modes.shapes}
    for name, values in columns.items():
        reason = _reason_against_column(values, len(np.atleast_1d(modes.frequency)))
        if not reason and name in ("frequency", "damping_ratio") and np.min(values) < 0:
            reason = "must not be negative"
        if reason:
            yield Problem(there, f"column {name!r} {reason}", shown)
            return
    if not modes.shapes:
        reason = "holds no point; add a column with mode shapes for each, named as the point is"
        yield Problem(there, reason, shown)
    if not _are_names(list(modes.shapes)):
        yield Problem(there, "name each point, by text without spaces around it", shown)
    for name in modes.shapes:
        if name in structure.names:
            yield Problem(there, f"a mode is called {name!r} already; name the point otherwise", shown)


def _reason_against_column(values: object, count: int) -> str:
    array = np.asarray(values)
    if array.dtype.kind not in "fiu" or array.ndim != 1 or not np.isfinite(array).all():
        return "must hold finite numbers"
    return "" if len(array) == count and count else f"holds {len(array)} numbers for {count} modes"
