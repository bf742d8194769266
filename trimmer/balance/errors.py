"""What can go wrong in harmonic balance."""

from __future__ import annotations

from trimmer.errors import TrimmerError


class FrequencyRangeError(TrimmerError, ValueError):
    """A range of frequencies that cannot be used."""


class LinearElementError(TrimmerError, ValueError):
    """The element's describing function does not depend on the amplitude, so nothing sets an amplitude."""


class UnsupportedElementError(TrimmerError, ValueError):
    """An element that is not of a kind the solver can treat."""


class UndecidedWarning(UserWarning):
    """Some part of the range is undecided: it may hold limit cycles that are not in the list."""
