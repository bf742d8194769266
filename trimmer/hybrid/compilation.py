"""Entry points of the compiled code, whose machine code is kept for the next process."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from pickle import UnpicklingError
from typing import Any, TypeVar

import numba

_Function = TypeVar("_Function", bound=Callable[..., Any])
_LEAN: dict[str, Any] = {"_nrt": False, "error_model": "numpy", "no_cfunc_wrapper": True}
# Compiled code makes no arrays: it is given them. So it need not count references to those that it passes on,
# which would take most of the time where there are many.
_INSIDE: dict[str, Any] = {**_LEAN, "no_cpython_wrapper": True}
compiled: Callable[[_Function], _Function] = numba.njit(fastmath={"contract"}, **_INSIDE)
"""Compile when a compiled function calls it. Product and sum may be one instruction, which rounds once."""
merged: Callable[[_Function], _Function] = numba.njit(fastmath={"contract"}, forceinline=True, **_INSIDE)
"""The same as ``compiled``, merged with its caller once it is compiled: for what is short, or called once."""
inlined = numba.njit(inline="always")
"""Compile as a part of the function that calls it: passing many arrays to another function costs time."""


@cache
def sources() -> bytes:
    """Return a digest of the modules of this folder, 32 bytes.

    Numba keeps machine code by the file of a function and by what the function closes over, but it does not
    notice a change in a function that is called. So every entry point closes over this digest.
    """
    digest = hashlib.sha256()
    for module in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(module.read_bytes())
    return digest.digest()


def kept(entry: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a function when it is first called, and keep the result where a folder can be written.

    That is the folder of the package, or else the user's cache; NUMBA_CACHE_DIR names another one. Processes
    that compile at the same time do not disturb each other, since files are written whole. Where nothing can
    be written, or a kept file is damaged, each process compiles for itself. With NUMBA_DISABLE_JIT=1 nothing
    is compiled.

    To look at the type of each array in each tuple takes Numba longer than a short motion. It does so once
    for arguments of some classes; later ones of the same classes go straight to the machine code.

    Args:
        entry: An entry point. It makes no arrays. Arguments of the same classes have the same types in each
            call: arrays have one shape of axes, one kind of numbers, and lie without gaps in the order of C.
    """
    for_itself: Callable[..., Any] = numba.njit(**_LEAN)(entry)
    if for_itself is entry:
        return entry
    try:
        machine: Any = numba.njit(cache=True, **_LEAN)(entry)
    except RuntimeError:  # There is no such folder.
        return for_itself

    known: dict[tuple[type, ...], Callable[..., Any]] = {}

    @wraps(entry)
    def call(*arguments: Any) -> Any:
        classes = tuple(map(type, arguments))
        if classes in known:
            return known[classes](*arguments)
        try:
            result = machine(*arguments)
        except (OSError, EOFError, UnpicklingError):
            return for_itself(*arguments)
        overload = machine.overloads.get(tuple(map(numba.typeof, arguments)))
        if overload is not None:
            known[classes] = overload.entry_point
        return result

    return call
