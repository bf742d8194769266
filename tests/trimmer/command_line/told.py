"""What a command has told, taken apart."""

from __future__ import annotations


def cells(lines: list[str] | str) -> list[list[str]]:
    """The cells of the lines of a table, which are two blanks apart."""
    text = lines if isinstance(lines, str) else "\n".join(lines)
    return [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in text.splitlines()]
