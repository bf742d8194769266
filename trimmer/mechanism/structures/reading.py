"""Structures from the tables of a mechanism's file, and the files that these name."""

import warnings
from collections.abc import Iterator, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from trimmer.mechanism.number_table import TableError, columns_of
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.structures.structure import LETTERS, MATRICES, MOST, ModalModel, Structure
from trimmer.messages import near_file

KEYS = tuple(each.name for each in fields(Structure) if each.name != "files")  # What a table may hold
COLUMNS = ("frequency", "damping_ratio")  # Columns of a modal model that are no points


class StructureError(ValueError):
    """What a key of a structure names is not what it should be; the message says why."""


def structure_of(
    place: tuple[str, ...], entries: Mapping[str, Any], folder: Path, problems: list[Problem]
) -> Structure:
    """Return the structure of a table; matrices are there or in a file, problems go into the list."""
    given, files = dict(entries), dict[str, str]()
    for key in (*MATRICES, "modes"):
        if key not in entries:
            continue
        try:
            if isinstance(entries[key], str):
                files[key] = entries[key]
                path = folder / files[key]
                given[key] = _modes(columns_of(path)) if key == "modes" else _matrix(path)
            elif key == "modes" and isinstance(entries[key], dict):
                given[key] = _modes(entries[key])
        except (StructureError, TableError) as error:
            problems.append(Problem((*place, key), str(error), files.get(key, entries[key])))
            given[key] = None
    return Structure(**given, files=files)


def problems_of_keys(place: tuple[str, ...], entries: Mapping[str, Any]) -> Iterator[Problem]:
    """Find what should be the name of a file, or what can stand in its place, and is not."""
    for key in (*MATRICES, "modes"):
        wanted = dict if key == "modes" else list
        if key in entries and not isinstance(entries[key], str | wanted):
            example = "modes.csv" if key == "modes" else f"{LETTERS[key]}.mtx"
            yield Problem((*place, key), f'name a file, as in {key} = "{example}"', entries[key])


def _modes(columns: Mapping[str, Any]) -> ModalModel:
    for name in COLUMNS:
        if name not in columns:
            raise StructureError(
                f"there is no column {name!r}; a modal model has frequency (Hz), damping_ratio, and a column "
                "of mode shapes for each point"
            )
    shapes = {name: values for name, values in columns.items() if name not in COLUMNS}
    return ModalModel(columns["frequency"], columns["damping_ratio"], shapes)


def _matrix(path: Path) -> Any:
    """Return the matrix of a Matrix Market file."""
    import numpy as np
    from scipy.io import mminfo, mmread

    try:
        rows, columns, *_ = mminfo(str(path))
        if max(rows, columns) > MOST:
            raise StructureError(f"has {rows} rows; reduce the model to at most {MOST}, as Craig-Bampton do")
        with warnings.catch_warnings():  # SciPy 1.18 tells that its default class will change; either does
            warnings.filterwarnings("ignore", message="The default value for `spmatrix`")
            matrix = mmread(str(path))
    except FileNotFoundError:
        raise StructureError(f"no such file; {near_file(path) or f'it is looked for as {path}'}") from None
    except OSError as reason:
        raise StructureError(f"cannot be read: {reason.strerror or reason}") from reason
    except (ValueError, OverflowError, TypeError) as reason:
        if isinstance(reason, StructureError):
            raise
        raise StructureError(f"is no Matrix Market file: {reason}") from reason
    return np.asarray(matrix.toarray() if hasattr(matrix, "toarray") else matrix)
