"""What of a mechanism can be an end, with its structures: coordinates and points, and what moves them.

Structures may be tables of a file here, before it is known whether they will do.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from trimmer.mechanism.parts import GROUND
from trimmer.mechanism.problems import Problem, no_such
from trimmer.mechanism.structures.structure import ModalModel, Structure
from trimmer.messages import listed

Content = Mapping[str, Any]  # Fields of a mechanism, or the content of a file


def structures_of(content: Content) -> Mapping[str, Structure]:
    """Return the structures; a table has the names that it gives, and points are known of a model alone."""
    parts = content.get("structures")
    return {
        str(name): part if isinstance(part, Structure) else _of_table(part)
        for name, part in (parts.items() if isinstance(parts, Mapping) else ())
    }


def _of_table(part: object) -> Structure:
    names = (
        [part.get(key) for key in ("coordinates", "rotations")] if isinstance(part, Mapping) else [None] * 2
    )
    coordinates, rotations = (tuple(each) if isinstance(each, list) else () for each in names)
    return Structure(coordinates=coordinates, rotations=rotations)


def rotations_in(content: Content) -> dict[str, bool]:
    """Return by its name whether each coordinate and point of structures is a rotation."""
    found: dict[str, bool] = {}
    for name, part in structures_of(content).items():
        turning = part.rotations if isinstance(part.rotations, list | tuple) else ()
        found |= {f"{name}.{each}": each in turning for each in _own_names(part)}
        found |= {f"{name}.{each}": False for each in _own_points(part)}
    return found


def coordinates_in(content: Content) -> list[str]:
    """Return the names of bodies and of those coordinates of structures to which parts may be attached."""
    structures = structures_of(content).items()
    named = (f"{name}.{each}" for name, part in structures if part.modes is None for each in _own_names(part))
    return [*content["bodies"], *named]


def modes_in(content: Content) -> list[str]:
    """Return the names of coordinates of modes, to which no part is attached."""
    structures = structures_of(content).items()
    return [
        f"{name}.{each}" for name, part in structures if part.modes is not None for each in _own_names(part)
    ]


def points_in(content: Content) -> dict[str, Mapping[str, float]]:
    """Return by its name the weights of coordinates at each point of the structures."""
    found: dict[str, Mapping[str, float]] = {}
    for name, part in structures_of(content).items():
        names = [f"{name}.{each}" for each in _own_names(part)]
        for point, shape in _own_points(part).items():
            found[f"{name}.{point}"] = dict(zip(names, map(float, shape), strict=False))
    return found


def weights_in(content: Content) -> dict[str, Mapping[str, float]]:
    """Return by the name of each end what weighs the coordinates in its displacement, if not with 0.

    Ends are the ground, the coordinates, the points and the pins; a pin has the weights of what carries it.
    Whatever else may stand as an end takes its weights here, and nowhere else.
    """
    found: dict[str, Mapping[str, float]] = {GROUND: {}}
    found |= {name: {name: 1.0} for name in (*coordinates_in(content), *modes_in(content))}
    sums = {name: point.weights for name, point in content["points"].items()} | points_in(content)
    for name, weights in sums.items():
        found[name] = {of: weight for of, weight in weights.items() if weight != 0}
    return found | {name: found.get(pin.on, {}) for name, pin in content["pins"].items()}


def _own_names(part: Structure) -> tuple[str, ...]:
    import numpy as np

    if part.modes is None:
        names = part.coordinates if isinstance(part.coordinates, list | tuple) else ()
        return tuple(each for each in names if isinstance(each, str))
    return part.names if isinstance(part.modes, ModalModel) and np.ndim(part.modes.frequency) else ()


def _own_points(part: Structure) -> Mapping[str, Any]:
    return part.modes.shapes if isinstance(part.modes, ModalModel) else {}


def no_such_end(content: Content, kind: str, name: str, known: list[str]) -> str:
    """Return why there is no such end, and what to write instead."""
    structures = structures_of(content)
    if name in modes_in(content):
        return f"no part is attached to a mode; name a point of the structure: {_ends_of(content, name)}"
    if name in structures:
        return f"{name!r} is a structure; name one of its coordinates or points: {_ends_of(content, name)}"
    return no_such(kind, name, known)


def _ends_of(content: Content, name: str) -> str:
    known = [*coordinates_in(content), *points_in(content)]
    owner = name if name in structures_of(content) else name.rpartition(".")[0]
    return listed((repr(each) for each in known if each.startswith(f"{owner}.")), "or")


def problems_of_names(content: Content) -> Iterator[Problem]:
    """Find coordinates and points of structures whose names others have."""
    taken = [GROUND, *content["bodies"], *content["pins"], *content["points"]]
    for structure in structures_of(content):
        only = {"bodies": {}, "structures": {structure: content["structures"][structure]}}
        for name in (*coordinates_in(only), *modes_in(only), *points_in(only)):
            if name in taken:
                reason = f"something else is called {name!r} already; give the structure another name"
                yield Problem(("structures", structure), reason)
            taken.append(name)


def problems_of_dots(content: Content) -> Iterator[Problem]:
    """Find names of coordinates without quotation marks, where TOML takes the dot for a table's."""
    for section in ("points", "outputs", "start"):
        tables = content.get(section)
        for name, entries in tables.items() if isinstance(tables, Mapping) else ():
            inner = {(name,): entries} if section == "start" else _tables(name, entries)
            for place, table in inner.items():
                if place[-1] in structures_of(content) and isinstance(table, Mapping):
                    written = f'"{place[-1]}.{next(iter(table), "u1")}"'
                    reason = f"write {written} in quotation marks; without them the dot begins a table"
                    yield Problem((section, *place), reason)


def _tables(name: str, entries: object) -> dict[tuple[str, ...], object]:
    if not isinstance(entries, Mapping):
        return {}
    found: dict[tuple[str, ...], object] = {(name, key): value for key, value in entries.items()}
    for key, value in entries.items():  # a velocity or acceleration is a table of such
        if isinstance(value, Mapping):
            found |= {(name, key, each): table for each, table in value.items()}
    return found
