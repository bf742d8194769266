"""Errors that the user of this package can correct, and warnings."""

__all__ = [
    "DivergingMotionError",
    "FitError",
    "FrequencyRangeError",
    "IllPosedLoopError",
    "LetterWarning",
    "LinearElementError",
    "LoopError",
    "MapError",
    "MapFileError",
    "MechanismError",
    "MissingPackageError",
    "OrbitNotFoundError",
    "OrbitNotFoundWarning",
    "SignalWarning",
    "TrimmerError",
    "UncertaintyError",
    "UndecidedWarning",
    "UnsupportedElementError",
    "UnsupportedMotionError",
    "WorkerError",
    "WrongTypeError",
]


class TrimmerError(Exception):
    """An input of the user cannot be used; the message is complete in itself and says what to do."""

    def __init__(self, *arguments: object, place: tuple[str, ...] = ()) -> None:
        """Take a message and, of what a file says, the names that lead there, such as ("start", "ball")."""
        super().__init__(*arguments)
        self.place = place


class WrongTypeError(TrimmerError, TypeError, ValueError):
    """An argument of another type than the one that is needed; the message names argument and value.

    It is a ``ValueError`` as well, so that what catches unusable values catches it too.
    """


class FrequencyRangeError(TrimmerError, ValueError):
    """A range of frequencies is not of the form 0 < lowest < highest < inf."""


class LinearElementError(TrimmerError, ValueError):
    """The element's describing function does not depend on the amplitude, so nothing sets an amplitude."""


class UnsupportedElementError(TrimmerError, ValueError):
    """The element is none, or its describing function is neither bounded nor proportional to 1/amplitude."""


class UndecidedWarning(UserWarning):
    """Part of the frequency range is undecided: it may hold limit cycles that are not in the list."""


class LetterWarning(UserWarning):
    """Letters of a name that no font of a picture has; boxes stand for them."""


class SignalWarning(UserWarning):
    """A record is clipped, or too short for what is asked, so that its spectrum is doubtful."""


class LoopError(TrimmerError, ValueError):
    """A loop has no such number, or it cannot have such a value; the message says which there are."""


class IllPosedLoopError(TrimmerError, ValueError):
    """The motion is not determined, because an output acts without delay on the input of its own element."""


class UnsupportedMotionError(TrimmerError, TypeError):
    """The element or the system has no motion in time, or not the motion that is asked for."""


class OrbitNotFoundWarning(UserWarning):
    """Newton's method found no periodic orbit from a guess, such as a limit cycle of harmonic balance."""


class OrbitNotFoundError(TrimmerError, ValueError):
    """A driven loop has no motion with the period of its drive that Newton's method finds."""


class DivergingMotionError(OrbitNotFoundError):
    """A motion without a drive grows without bound."""


class MechanismError(TrimmerError, ValueError):
    """A mechanism, or the file of one, cannot be used; each problem is named with its place and remedy."""


class MapError(TrimmerError, ValueError):
    """A map cannot be made of what is given; the message says what to give."""


class MapFileError(TrimmerError, ValueError):
    """The file of a map cannot be gone on with; the message says why and what to do."""


class UncertaintyError(TrimmerError, ValueError):
    """Numbers that scatter in a way that cannot be sampled or analysed."""


class WorkerError(TrimmerError, RuntimeError):
    """A process that did the work of cells ended at once, as when memory runs out."""


class MissingPackageError(TrimmerError, ImportError):
    """A package that few need is not installed; the message says how to install it."""


class FitError(TrimmerError, ValueError):
    """Numbers of a mechanism cannot be fitted to a measurement; the message says why and what to do."""
