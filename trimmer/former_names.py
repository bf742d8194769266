"""Names that stood in a room once, and the names under which the same stands now."""

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any
from warnings import warn


def answering(room: str, attribute: Callable[[str], Any], former: Mapping[str, str]) -> Callable[[str], Any]:
    """Return the ``__getattr__`` of a room that answers to former names too, with a warning.

    ``attribute`` is that for the other names; ``former`` gives room and name by the name that it had.
    """

    def answer(name: str) -> Any:
        if name not in former:
            return attribute(name)
        place, _, now = former[name].rpartition(".")
        told = f"{room}.{name} is {former[name]} now: from {place} import {now}"
        warn(told, DeprecationWarning, stacklevel=2)
        return getattr(import_module(place), now)

    return answer
