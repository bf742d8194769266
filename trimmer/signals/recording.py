"""A recording: the stretches of a signal between gaps, and the gaps."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from trimmer.showing.shown import Shown, counted
from trimmer.signals.signal import Signal, SignalError

SHOWN_GAPS = 3  # How many are told


@dataclass(frozen=True)
class Gap:
    """A stretch of time without samples.

    Attributes:
        begin, end: Times of the last sample before it and of the first after it, s.
        line: Number of the line after it in the file.
        missing: About how many samples are missing.
    """

    begin: float
    end: float
    line: int
    missing: int

    @property
    def sentence(self) -> str:
        """Time and length, without a full stop."""
        return (
            f"gap of {self.end - self.begin:.6g} s after {self.begin:.9g} s (line {self.line}), "
            f"about {self.missing} sample{'s' if self.missing > 1 else ''}"
        )


@dataclass(frozen=True, eq=False, repr=False)
class Recording(Shown):
    """Stretches of one signal, all at the same sample rate, in order of time.

    Attributes:
        stretches: The stretches, at least one.
        gaps: Gaps in the file; more than those between the stretches if only a part of it is taken.
    """

    stretches: tuple[Signal, ...]
    gaps: tuple[Gap, ...] = ()

    def _told(self) -> str:
        parts = (counted(len(self.stretches), "stretch"), counted(len(self.gaps), "gap"))
        return f"{self.stretches[0].heading}, {', '.join(parts)}, {counted(self.samples, 'sample')}"

    @property
    def samples(self) -> int:
        """Number of samples of all stretches."""
        return sum(stretch.values.size for stretch in self.stretches)

    @property
    def longest(self) -> Signal:
        """The longest stretch, the first of several; its notes say what it leaves out."""
        longest = max(self.stretches, key=lambda stretch: stretch.values.size)
        if len(self.stretches) == 1:
            return longest
        left = self.samples - longest.values.size
        told = (
            f"the longest of {len(self.stretches)} stretches without a gap is used, from "
            f"{longest.start:.6g} s on for {longest.duration:.6g} s; {left} samples of the others are left "
            "out, and no gap is bridged"
        )
        return replace(longest, notes=(*longest.notes, told))

    def between(self, begin: float = -math.inf, end: float = math.inf) -> Recording:
        """Return what was recorded from one time to another, s, both included.

        Raises:
            SignalError: if that is nothing.
        """
        kept = []
        problem: SignalError | None = None
        for stretch in self.stretches:
            try:
                kept.append(stretch.between(begin, end))
            except SignalError as error:
                problem = error
        if not kept and problem is not None:
            raise problem
        return Recording(tuple(kept), self.gaps)


def told_gaps(gaps: tuple[Gap, ...]) -> str:
    """Name the first gaps, and how many there are, without a full stop."""
    first = "; ".join(gap.sentence for gap in gaps[:SHOWN_GAPS])
    return f"{len(gaps)} gap{'s' if len(gaps) > 1 else ''} in the time stamps: {first}" + (
        "; ..." if len(gaps) > SHOWN_GAPS else ""
    )
