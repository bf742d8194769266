"""Pages of the library reference: every public name of the stubs of ``trimmer``, a page for each room."""

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path

BASICS = "basics"
"""The page of what stands in no room of its own."""
TITLES = {
    BASICS: "Parameters, files, errors",
    "balance": "Harmonic balance",
    "branches": "Branches",
    "design": "Designs",
    "elements": "Elements",
    "ensembles": "Many loops at once",
    "linear": "Linear model",
    "maps": "Maps and basins",
    "mechanism": "Mechanism",
    "motion": "Exact simulation of loops",
    "orbits": "Exact orbits of loops",
    "proof": "Proofs by ball arithmetic",
    "response": "Motion of mechanisms",
    "runners": "Processes and clusters",
    "signals": "Signals",
    "spectra": "Spectra",
    "thesis": "The trimmer of the thesis",
    "uncertainty": "Numbers that scatter",
}
"""Titles of rooms whose name does not say enough."""
MODULES = ("choices", "errors", "files")
"""Modules with public names, in ``__all__``, that stand in no room of their own."""

Entry = tuple[str, str]
"""The package that a name is imported from, and the name."""


def library_pages(project: Path) -> dict[str, tuple[str, str]]:
    """Return title and Markdown of each page by its name; the page ``index`` lists all names."""
    rooms = public_names(project / "trimmer")
    pages = {room: (_title(room), _page(room, names)) for room, names in sorted(rooms.items(), key=_order)}
    return {"index": ("Overview", _overview(rooms)), **pages}


def public_names(package: Path) -> dict[str, list[Entry]]:
    """Return the public names by the room they come from: functions, classes, errors."""
    rooms: dict[str, list[Entry]] = {}
    known = set()
    for module, name in _exported(package):
        first, *deeper = module.split(".")
        rooms.setdefault(first if deeper else BASICS, []).append(("trimmer", name))
        known.add(name)
    for stub in sorted(package.glob("*/__init__.pyi")):
        room = stub.parent.name
        names = [name for _, name in _exported(stub.parent) if name not in known]
        rooms.setdefault(room, []).extend((f"trimmer.{room}", name) for name in names)
        known.update(names)
    for module in MODULES:
        names = [name for name in _all_of(package / f"{module}.py") if name not in known]
        rooms[BASICS] += [(f"trimmer.{module}", name) for name in names]
        known.update(names)
    return {room: sorted(names, key=_rank) for room, names in rooms.items()}


def _exported(package: Path) -> Iterator[tuple[str, str]]:
    """Yield module and name of all that the stub of a package exports."""
    for statement in ast.parse((package / "__init__.pyi").read_text(encoding="utf-8")).body:
        if isinstance(statement, ast.ImportFrom) and statement.module is not None:
            yield from ((statement.module, alias.asname or alias.name) for alias in statement.names)


def _all_of(module: Path) -> list[str]:
    """Return what a module says in ``__all__``."""
    for statement in ast.parse(module.read_text(encoding="utf-8")).body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "__all__":
            return [str(name) for name in ast.literal_eval(statement.value)]
    return []


def _rank(entry: Entry) -> tuple[int, str]:
    """Put functions before classes, and errors last."""
    name = entry[1]
    is_error = name.endswith(("Error", "Warning", "Interrupted"))
    return 2 if is_error else 0 if name.islower() else 1, name.lower()


def _order(entry: tuple[str, list[Entry]]) -> str:
    return "" if entry[0] == BASICS else _title(entry[0])


def _title(room: str) -> str:
    return TITLES.get(room, room.replace("_", " ").capitalize())


def _page(room: str, names: list[Entry]) -> str:
    blocks = [f"# {_title(room)}", *(_entry(*each) for each in names)]
    return "\n\n".join(blocks) + "\n"


def _entry(package: str, name: str) -> str:
    return f"::: {package}.{name}\n    options:\n      heading: {name}\n      toc_label: {name}\n"


def _called(package: str, name: str) -> str:
    """Return a name with its room, if it has one."""
    return f"{package}.{name}".removeprefix("trimmer.")


def _overview(rooms: Mapping[str, list[Entry]]) -> str:
    lines = [
        "# Library",
        "Names are imported from `trimmer`, or from the room that stands before them, such as"
        " `trimmer.signals`; each is loaded when it is first used.",
        "Lengths are in m, masses in kg, times in s, forces in N; `omega` is in rad/s, `frequency` in Hz,"
        " `amplitude` is half of peak to peak, `gap` the total clearance. Results are frozen dataclasses;"
        " errors that a user can correct are `TrimmerError`s.",
    ]
    for room, names in sorted(rooms.items(), key=_order):
        links = ", ".join(f"[`{_called(*each)}`][{'.'.join(each)}]" for each in names)
        lines.append(f"## [{_title(room)}]({room}.md)\n\n{links}")
    return "\n\n".join(lines) + "\n"
