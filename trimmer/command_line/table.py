"""Tables as plain text, each column as wide as its widest cell, and shares that may be rounding."""

from collections.abc import Sequence

SMALLEST = 1e-12
"""Share of one below which a multiplier, or what a balance is off by, is a bound and not a number."""


def table(heads: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return lines with rows in columns under their heads, or ``none`` if there is no row."""
    if not rows:
        return ["  none"]
    listed = [heads, *rows]
    widths = [max(len(row[column]) for row in listed) for column in range(len(heads))]
    return ["  " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in listed]


def or_rounding(share: float, form: str) -> str:
    """Return a share in a form, or ``less than 1e-12``."""
    return format(share, form) if abs(share) >= SMALLEST else f"less than {SMALLEST:g}"
