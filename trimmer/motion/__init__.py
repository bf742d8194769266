"""The exact motion of whatever moves, and what is measured of it: for mechanisms and loops alike.

A ``subject`` is what moves, as data; its ``flow`` is what all else asks for a ``Course``. ``part`` says which
phases begin and end, ``signals`` what is read, ``extremes`` and ``fourier`` measure signals exactly, and
``measures`` collects that.
"""

from importlib import import_module
from typing import Any
from warnings import warn

__all__: tuple[str, ...] = ()  # Nothing is public here: what is measured of a motion is asked of a result


def __getattr__(name: str) -> Any:
    """Return what stood here before loops had a room of their own, with a warning."""
    if name == "Motion":
        return import_module("trimmer.motion.motion").Motion
    loops = import_module("trimmer.loops")
    if name.startswith("_") or name not in dir(loops):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    told = f"trimmer.motion.{name} stands in trimmer.loops: from trimmer.loops import {name}"
    warn(told, DeprecationWarning, stacklevel=2)
    return getattr(loops, name)
