"""Reads docs/json.md, and the keys of JSON as it names them."""

import re
from collections.abc import Collection, Iterator
from pathlib import Path

DOCUMENT = Path(__file__).parents[1] / "docs" / "json.md"


def documented(heading: str) -> set[str]:
    """Return the keys in the first column of the table below a heading."""
    (section,) = re.findall(
        rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", DOCUMENT.read_text("utf-8"), re.MULTILINE | re.DOTALL
    )
    firsts = (line.split(" | ")[0] for line in section.splitlines() if line.startswith("| `"))
    return {key for first in firsts for key in re.findall(r"`([^`]+)`", first)}


def keys(value: object, named_by_data: Collection[str] = (), path: str = "") -> Iterator[str]:
    """Yield the paths of all that is no object or list of objects, and of objects whose keys are data."""
    if isinstance(value, dict) and path not in named_by_data:
        for key, inner in value.items():
            yield from keys(inner, named_by_data, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and any(isinstance(entry, dict) for entry in value):
        for entry in value:
            yield from keys(entry, named_by_data, f"{path}[]")
    else:
        yield path
