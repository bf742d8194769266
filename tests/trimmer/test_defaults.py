"""Defaults of all that is public are as in ``defaults.txt``; this module, run with ``-m``, renews it.

Whoever leaves an argument out rests on its default, so a changed one is a change of what is public. What is
new is held from when the file is written again.
"""

import inspect
from collections.abc import Callable, Iterator
from dataclasses import is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any

from tests.public_names import public_names

KEPT = Path(__file__).with_name("defaults.txt")


def _called(name: str, thing: Any) -> Iterator[tuple[str, Callable[..., Any]]]:
    """Yield a function, or a class and its public methods, with their names."""
    is_class = inspect.isclass(thing) and not issubclass(thing, Enum | Exception)
    if is_class or inspect.isfunction(thing):
        yield name, thing
    for key in vars(thing) if is_class else ():
        method = getattr(thing, key)
        if not key.startswith("_") and (inspect.isfunction(method) or inspect.ismethod(method)):
            yield f"{name}.{key}", method


def _told(default: Any) -> str:
    """Return a default as text; settings by their name, as theirs are told for themselves."""
    told, kind = str(getattr(default, "__name__", repr(default))), type(default)
    return f"{kind.__name__}(...)" if is_dataclass(kind) and told.startswith(f"{kind.__name__}(") else told


def defaults() -> dict[str, str]:
    """Return the default of each argument that has one, by the name of what is called and its own."""
    return {
        f"{name}({each.name})": _told(each.default)
        for public, thing in sorted(public_names().items())
        for name, called in _called(public, thing)
        for each in inspect.signature(called).parameters.values()
        if each.default is not each.empty and not each.name.startswith("_")
    }


def test_defaults_are_as_they_were() -> None:
    kept = dict(line.split(" = ", 1) for line in KEPT.read_text("utf-8").splitlines())
    now = defaults()
    assert len(kept.keys() & now.keys()) > 400
    assert {name: now[name] for name in kept if now.get(name, kept[name]) != kept[name]} == {}


if __name__ == "__main__":
    KEPT.write_text("".join(f"{name} = {value}\n" for name, value in defaults().items()), "utf-8")
