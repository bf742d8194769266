"""What a check raises where balls do not tell."""

from __future__ import annotations


class UndecidedError(Exception):
    """The message says, without a full stop, what could not be told."""
