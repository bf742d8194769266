"""Units in the headings of CSV files: which ones are known, and how they are written."""

import re

from trimmer.signals.quantity import MOTION_UNITS

SECONDS = {"": 1.0, "s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9}
"""Units of time, in seconds; a heading without unit means seconds."""

_OTHERS = {*MOTION_UNITS, "N", "Pa", "V", "mV"}
_BRACKETED = re.compile(r"\[[^][]*\]|\([^()]*\)")


def is_unit(cell: str) -> bool:
    """Return whether a cell of a heading holds a unit alone, in brackets or a common one; or nothing."""
    return cell.strip() in SECONDS or cell.strip() in _OTHERS or _is_bracketed(cell)


def in_brackets(cell: str) -> str:
    """Return a unit in brackets, with those that it has or new ones; an empty cell stays empty."""
    unit = cell.strip()
    return unit if not unit or _is_bracketed(unit) else f"[{unit}]"


def _is_bracketed(cell: str) -> bool:
    return _BRACKETED.fullmatch(cell.strip()) is not None
