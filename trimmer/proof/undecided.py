"""What a check raises where balls do not tell, or tell otherwise."""

from __future__ import annotations


class UndecidedError(Exception):
    """The message says, without a full stop, what could not be told."""


class RefutedError(Exception):
    """The message says, without a full stop, what is wrong."""
