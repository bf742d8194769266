"""Tables as plain text."""

from __future__ import annotations

from collections.abc import Sequence


def table(heads: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Lay rows out in columns under their heads, as lines; ``none`` if there is no row."""
    if not rows:
        return ["  none"]
    listed = [heads, *rows]
    widths = [max(len(row[column]) for row in listed) for column in range(len(heads))]
    return ["  " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in listed]
