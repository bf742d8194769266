"""What can go wrong: errors that the user of this package can put right, and warnings."""

from __future__ import annotations


class TrimmerError(Exception):
    """Something given by the user cannot be used; the message stands alone and says what to do."""


class WrongTypeError(TrimmerError, TypeError):
    """An argument of another type than the one that is needed; the message names argument and value."""


class FrequencyRangeError(TrimmerError, ValueError):
    """A range of frequencies that cannot be used."""


class LinearElementError(TrimmerError, ValueError):
    """The element's describing function does not depend on the amplitude, so nothing sets an amplitude."""


class UnsupportedElementError(TrimmerError, ValueError):
    """An element that is not of a kind the solver can treat."""


class UndecidedWarning(UserWarning):
    """Some part of the range is undecided: it may hold limit cycles that are not in the list."""


class IllPosedLoopError(TrimmerError, ValueError):
    """The motion is not determined, because an output acts on the input of its own element at once."""


class UnsupportedMotionError(TrimmerError, TypeError):
    """The element has a describing function but no motion in time."""


class OrbitNotFoundWarning(UserWarning):
    """From a guess no periodic orbit was found."""


class OrbitNotFoundError(TrimmerError, ValueError):
    """A driven loop has no motion with the period of its drive that Newton's method finds."""
