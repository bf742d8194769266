"""The chapter on what section 6.4 of the thesis asks for: its sections with their numbers."""

from typing import Final

from report.document.extras import FutureWork
from report.future_work.sections import compensation, felt, harmonics, load, scatter, second_play
from report.numbers.evidence import Evidence

TITLE: Final = "What the thesis left open, answered"
SECTIONS: Final = (
    compensation.SECTION,
    harmonics.SECTION,
    second_play.SECTION,
    scatter.SECTION,
    load.SECTION,
    felt.SECTION,
)


def future_work(known: Evidence) -> FutureWork:
    """Return the chapter.

    Raises:
        KeptDataError: if data that are kept with the code are missing, or were made from something else.
        UnsupportedObservationError: if a check of an observation does not hold.
    """
    return FutureWork(TITLE, tuple(section.finished(known) for section in SECTIONS))
