"""Tables as plain text, each column as wide as its widest cell."""

from collections.abc import Sequence


def table(heads: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return lines with rows in columns under their heads, or ``none`` if there is no row."""
    if not rows:
        return ["  none"]
    listed = [heads, *rows]
    widths = [max(len(row[column]) for row in listed) for column in range(len(heads))]
    return ["  " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in listed]
