"""Pages of the library reference: every public name of ``trimmer/__init__.pyi``, a page for each room."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from pathlib import Path

STUB = Path("trimmer") / "__init__.pyi"
BASICS = "basics"
"""The page of what stands in no room of its own."""
TITLES = {
    BASICS: "Parameters, files, errors",
    "balance": "Harmonic balance",
    "branches": "Branches",
    "elements": "Elements",
    "ensembles": "Many loops at once",
    "linear": "Linear model",
    "maps": "Maps and basins",
    "mechanism": "Mechanism",
    "motion": "Exact simulation of loops",
    "orbits": "Exact orbits of loops",
    "response": "Motion of mechanisms",
    "runners": "Processes and clusters",
    "signals": "Signals",
    "spectra": "Spectra",
}
"""Titles of rooms whose name does not say enough."""
PARTS = ("Body", "Pin", "Link", "Play", "Stop", "Friction", "Force", "Output")
"""Public in ``trimmer.mechanism``, since ``trimmer.Body`` is a body of the thesis's trimmer."""


def library_pages(project: Path) -> dict[str, tuple[str, str]]:
    """Return title and Markdown of each page by its name; the page ``index`` lists all names."""
    rooms = public_names((project / STUB).read_text(encoding="utf-8"))
    pages = {room: (_title(room), _page(room, names)) for room, names in sorted(rooms.items(), key=_order)}
    return {"index": ("Overview", _overview(rooms)), **pages}


def public_names(stub: str) -> dict[str, list[str]]:
    """Return the public names by the room they come from: functions, classes, errors."""
    rooms: dict[str, list[str]] = {}
    for statement in ast.parse(stub).body:
        if isinstance(statement, ast.ImportFrom) and statement.module is not None:
            first, *deeper = statement.module.split(".")
            names = rooms.setdefault(first if deeper else BASICS, [])
            names += [alias.asname or alias.name for alias in statement.names]
    return {room: sorted(names, key=_rank) for room, names in rooms.items()}


def _rank(name: str) -> tuple[int, str]:
    """Put functions before classes, and errors last."""
    is_error = name.endswith(("Error", "Warning", "Interrupted"))
    return 2 if is_error else 0 if name.islower() else 1, name.lower()


def _order(entry: tuple[str, list[str]]) -> str:
    return "" if entry[0] == BASICS else _title(entry[0])


def _title(room: str) -> str:
    return TITLES.get(room, room.replace("_", " ").capitalize())


def _page(room: str, names: list[str]) -> str:
    blocks = [f"# {_title(room)}", *(_entry("trimmer", name) for name in names)]
    if room == "mechanism":
        blocks += ["## Parts\n\nThese are imported from `trimmer.mechanism`."]
        blocks += [_entry("trimmer.mechanism", name) for name in PARTS]
    return "\n\n".join(blocks) + "\n"


def _entry(package: str, name: str) -> str:
    return f"::: {package}.{name}\n    options:\n      heading: {name}\n      toc_label: {name}\n"


def _overview(rooms: Mapping[str, list[str]]) -> str:
    lines = [
        "# Library",
        "All names are imported from `trimmer`; each is loaded when it is first used.",
        "Lengths are in m, masses in kg, times in s, forces in N; `omega` is in rad/s, `frequency` in Hz,"
        " `amplitude` is half of peak to peak, `gap` the total clearance. Results are frozen dataclasses;"
        " errors that a user can correct are `TrimmerError`s.",
    ]
    for room, names in sorted(rooms.items(), key=_order):
        links = ", ".join(f"[`{name}`][trimmer.{name}]" for name in names)
        lines.append(f"## [{_title(room)}]({room}.md)\n\n{links}")
    return "\n\n".join(lines) + "\n"
