"""What can be wrong with a loop whose motion is asked for."""

from trimmer.errors import TrimmerError


class IllPosedLoopError(TrimmerError, ValueError):
    """The motion is not determined, because an output acts on the input of its own element at once."""


class UnsupportedMotionError(TrimmerError, TypeError):
    """The element has a describing function but no motion in time."""
