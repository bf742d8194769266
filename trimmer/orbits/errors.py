"""What the search for periodic orbits reports."""

from trimmer.errors import TrimmerError


class OrbitNotFoundWarning(UserWarning):
    """From a guess no periodic orbit was found."""


class OrbitNotFoundError(TrimmerError, ValueError):
    """A driven loop has no motion with the period of its drive that Newton's method finds."""
