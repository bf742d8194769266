"""JSON as commands print it, with infinite, missing and complex numbers in a form that it has."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from trimmer.choices import Choice


def document(content: object) -> str:
    """Return what a command prints as JSON: its values as ``plain`` makes them."""
    return json.dumps(plain(content), indent=2, allow_nan=False)


def picked(source: object, *names: str) -> dict[str, Any]:
    """Return attributes of a result by their names, which are the keys of its JSON."""
    return {name: getattr(source, name) for name in names}


def plain(value: Any) -> Any:
    """Return a value in forms that JSON has: arrays as lists, choices by word, None for infinity and NaN.

    A complex number is a list of its real and imaginary part.
    """
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, complex):
        value = [value.real, value.imag]
    if isinstance(value, Mapping):
        return {name: plain(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    if isinstance(value, Choice):
        return value.word
    if isinstance(value, Path):
        return str(value)
    return None if isinstance(value, float) and not math.isfinite(value) else value
