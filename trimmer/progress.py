"""Progress bars on standard error, and whether anything is told there at all."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tqdm import tqdm

SILENCE = 2.0  # Time after which a bar appears, s

_SILENT: ContextVar[bool] = ContextVar("silent", default=False)


@contextmanager
def silenced() -> Iterator[None]:
    """Show neither progress nor warnings while the block runs, in this thread."""
    before = _SILENT.set(True)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        _SILENT.reset(before)


def is_silenced() -> bool:
    """Say whether nothing but errors is to be told."""
    return _SILENT.get()


def progress_bar(
    items: Iterable[Any] | None = None, description: str = "", *, quiet: bool = False, **settings: Any
) -> tqdm[Any]:
    """Return a bar of tqdm on standard error, for what takes longer than ``SILENCE``; on a terminal only."""
    from tqdm import tqdm

    hidden = True if quiet or is_silenced() else None  # None: shown on a terminal
    return tqdm(items, description, delay=SILENCE, leave=False, disable=hidden, **settings)
