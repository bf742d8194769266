"""What a command has told, taken apart."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np


def cells(lines: list[str] | str) -> list[list[str]]:
    """The cells of the lines of a table, which are two blanks apart."""
    text = lines if isinstance(lines, str) else "\n".join(lines)
    return [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in text.splitlines()]


def point_of_branch(value: float = 1.0, *, stable: bool = True, converged: bool = True) -> SimpleNamespace:
    """A point of a followed branch as commands see it, with one output and one multiplier."""
    return SimpleNamespace(
        value=value,
        period=0.5,
        stable=stable,
        multipliers=np.array([0.5 - 0.25j]),
        events_per_period=2,
        outputs={"x": SimpleNamespace(advance=0.5, peak_to_peak=4.0, harmonics=np.array([2.0, 1.0]))},
        balanced=lambda count: SimpleNamespace(distance=float(count), converged=converged),
    )
