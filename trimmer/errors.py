"""The base of all errors that the user of this package can put right."""

from __future__ import annotations


class TrimmerError(Exception):
    """Something given by the user cannot be used; the message stands alone and says what to do."""
