"""The period that is counted, of a drive or only a sample: its name, and how much happens in it."""

from trimmer.mechanism.drives import clocks_in, sines_in
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.subject import Subject
from trimmer.showing.shown import counted

DRIVE_PERIOD = "drive period"
"""What is counted of whatever is driven by more than samples."""
SAMPLES = 16
"""Samples in which a sampled machine does as much as another one in a period of its drive."""


def is_driven(subject: Subject) -> bool:
    """Say whether something has a drive; a sine of a reference and the clock of a controller are such."""
    clocked = isinstance(subject, Mechanism) and bool(clocks_in(subject) or sines_in(subject))
    return clocked or subject.frequency is not None


def pace_of(subject: Subject) -> int:
    """Return in how many drive periods as much happens as in one: many, if they are samples alone."""
    return SAMPLES if _only_samples(subject) else 1


def period_word(subject: Subject) -> str:
    """Return what is counted: periods of a drive, or the samples that alone drive."""
    if not isinstance(subject, Mechanism) or not _only_samples(subject):
        return DRIVE_PERIOD
    return "sample" if len(set(clocks_in(subject).values())) == 1 else "period of the slowest samples"


def periods_of(subject: Subject, count: float) -> str:
    """Return a number of these periods in words, as ``300 drive periods`` or ``256 samples``."""
    word = period_word(subject)
    head, *tail = word.split(" of ")
    return " of ".join([counted(f"{count:.9g}", head), *tail])


def waited(subject: Subject, most_periods: int) -> str:
    """Return in words how long is waited: these periods, or without a drive those of the slowest mode."""
    if is_driven(subject):
        return periods_of(subject, most_periods)
    return f"{most_periods} periods of its slowest mode"


def _only_samples(subject: Subject) -> bool:
    if not isinstance(subject, Mechanism) or subject.frequency is not None:
        return False
    return bool(clocks_in(subject)) and not sines_in(subject)
