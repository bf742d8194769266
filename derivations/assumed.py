"""Symbols by what is assumed of them; several names, with blanks between them, give several symbols."""

from typing import Any

import sympy


def positive(names: str) -> Any:
    """Return what is positive."""
    return sympy.symbols(names, positive=True)


def nonnegative(names: str) -> Any:
    """Return what is positive or zero."""
    return sympy.symbols(names, nonnegative=True)


def real(names: str) -> Any:
    """Return what is real, of either sign."""
    return sympy.symbols(names, real=True)
