"""How fast things happen beside the period that is counted: slowly, where that is only a sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.mechanism.drives import clocks_in, sines_in
from trimmer.mechanism.mechanism import Mechanism

if TYPE_CHECKING:
    from trimmer.motion.subject import Subject

SAMPLES = 16
"""Samples in which a sampled machine does as much as another one in a period of its drive."""


def pace_of(subject: Subject) -> int:
    """Return in how many drive periods as much happens as in one: many, if they are samples alone."""
    if not isinstance(subject, Mechanism) or subject.frequency is not None:
        return 1
    return SAMPLES if clocks_in(subject) and not sines_in(subject) else 1
