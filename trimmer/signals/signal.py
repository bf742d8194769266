"""A signal sampled at equal distances in time."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_number, require_instance, require_instances, whole_number
from trimmer.arrays import Reals
from trimmer.errors import TrimmerError
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table, arrays
from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.quantity import MotionQuantity, in_si, quantity_of

_HEADING = re.compile(r"(?P<name>.*?)\s*(?:\[(?P<square>[^][]*)\]|\((?P<round>[^()]*)\))?", flags=re.DOTALL)

LARGEST_VALUE = 1e300  # Largest sample; sums and products with larger ones would not be numbers any more


class SignalError(TrimmerError, ValueError):
    """A signal, or an argument of its analysis, cannot be used; the message says why and what to do."""


@dataclass(frozen=True, eq=False, repr=False)
class Signal(Tabular, Drawn):
    """A signal sampled at equal distances in time.

    ``plot`` draws the samples over time, s.

    Attributes:
        values: Samples, shape (n,), n >= 1, finite, in ``unit``; a copy of what was given, not writable.
        sample_rate: Samples per second, Hz, > 0.
        name: What it is, one line; in a file it is the heading of the column.
        unit: Unit of the values, empty if it is not known.
        start: Time of the first sample, s.
        interpolated: How many of the samples are not measured but interpolated.
        trusted: Frequencies at which the samples can be trusted, as far as that is known.
        notes: What was done to the samples or assumed, in sentences without a full stop.
        full_scale: Largest value that the device can give, in ``unit``, > 0; infinite if it is not known.
        converted: How often it was differentiated after it was measured, negative if integrated: what was
            white noise then grows with this power of the frequency.

    Raises:
        SignalError: if any of these does not hold.
    """

    values: Reals
    sample_rate: float
    name: str = "signal"
    unit: str = ""
    start: float = 0.0
    interpolated: int = 0
    trusted: Band = EVERYWHERE
    notes: tuple[str, ...] = ()
    full_scale: float = math.inf
    converted: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", checked_samples(self.values))
        object.__setattr__(self, "sample_rate", checked_rate(self.sample_rate))
        for name in ("name", "unit"):
            require_instance(name, getattr(self, name), str, "a text")
        whole_number("interpolated", self.interpolated, 0)
        whole_number("converted", self.converted)
        require_instance("trusted", self.trusted, Band, "a trimmer.signals.Band")
        if not real_number("full_scale", self.full_scale, self.unit) > 0:
            raise SignalError(f"full_scale is {self.full_scale!r}: it must be positive, or infinite")
        object.__setattr__(self, "notes", require_instances("notes", self.notes, str, "a text"))
        if not math.isfinite(real_number("start", self.start, "s")):
            raise SignalError(f"start is {self.start!r}: the time of the first sample must be finite")
        if split_heading(self.heading) != (self.name, self.unit) or not self.name:
            raise SignalError(
                f"a signal cannot have the name {self.name!r} and the unit {self.unit!r}: both are one line "
                "of printable signs with single spaces and no brackets at the end; the name is not empty"
            )

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take what was pickled; the values are not writable again."""
        vars(self).update(state)
        self.values.flags.writeable = False

    @property
    def heading(self) -> str:
        """Name, followed by the unit in brackets if there is one; ``split_heading`` takes it apart."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def times(self) -> Reals:
        """Times of the samples, s, shape (n,)."""
        return np.asarray(self.start + np.arange(self.values.size) / self.sample_rate)

    @property
    def duration(self) -> float:
        """Number of samples over sample rate, s: each sample stands for one sampling interval."""
        return self.values.size / self.sample_rate

    def _told(self) -> str:
        samples = counted(self.values.size, "sample")
        return f"{self.heading}, {samples} at {self.sample_rate:.9g} Hz, {self.duration:.6g} s"

    def _table(self) -> Table:
        name = self.name if self.name != "time" else "value"
        columns = (*arrays(time=("s", self.times)), Column(name, self.unit, self.values.__getitem__))
        return Table(f"Samples of {self.name}", range(self.values.size), columns)

    @property
    def rms(self) -> float:
        """Root mean square about the mean, in ``unit``."""
        scale = float(np.abs(self.values).max()) or 1.0
        return scale * float((self.values / scale).std())

    @property
    def quantity(self) -> MotionQuantity:
        """What it is, by its unit."""
        return quantity_of(self.unit)

    def in_si(self) -> Signal:
        """Return the signal in the unit of its quantity in SI; one that is no motion stays as it is."""
        unit = self.quantity.unit
        if unit in ("", self.unit):
            return self
        return self.scaled(in_si(self.unit), unit)

    def scaled(self, factor: float = 1.0, unit: str | None = None) -> Signal:
        """Return the signal times a factor, in another unit if one is given.

        Raises:
            SignalError: if the factor is 0, infinite or NaN, or the unit is none.
        """
        if not 0 < abs(real_number("factor", factor)) < math.inf:
            raise SignalError(f"the factor must be finite and not 0, not {factor!r}")
        unit = self.unit if unit is None else unit
        full_scale = self.full_scale * abs(float(factor))
        return replace(self, values=self.values * float(factor), unit=unit, full_scale=full_scale)

    def between(self, begin: float = -math.inf, end: float = math.inf) -> Signal:
        """Return the samples from one time to another, s, both included.

        Raises:
            SignalError: if there is none.
        """
        begin, end = real_number("begin", begin, "s"), real_number("end", end, "s")
        near = 1e-6 / self.sample_rate
        kept = np.flatnonzero((self.times >= begin - near) & (self.times <= end + near))
        if kept.size == 0:
            raise SignalError(
                f"no sample lies from {begin:g} s to {end:g} s: the record goes from {self.start:g} s to "
                f"{self.times[-1]:g} s"
            )
        first = int(kept[0])
        return replace(self, values=self.values[first : int(kept[-1]) + 1], start=float(self.times[first]))


def split_heading(heading: str) -> tuple[str, str]:
    """Split the heading of a column into name and unit, which is in brackets at its end or else empty.

    Each run of spaces and line ends becomes one space; what cannot be printed becomes U+FFFD.
    """
    spaced = " ".join(heading.split())
    text = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in spaced)
    match = _HEADING.fullmatch(text)
    assert match is not None  # the name takes whatever the unit does not
    unit = match["square"] or match["round"] or ""
    return (match["name"], unit.strip()) if match["name"] else (text, "")


def checked_samples(values: ArrayLike) -> Reals:
    """Copy samples into an array, shape (n,), that cannot be written to."""
    try:
        given = np.asarray(values)
        samples = np.array(given, dtype=np.float64) if given.dtype.kind in "fiu" else None
    except (TypeError, ValueError):  # nested lists of unequal length
        samples = None
    if samples is None or samples.ndim != 1 or samples.size == 0:
        raise SignalError("the samples of a signal must be real numbers in one dimension, at least one")
    unusable = np.flatnonzero(~np.isfinite(samples))
    if unusable.size:
        first = int(unusable[0])
        raise SignalError(
            f"{unusable.size} of {samples.size} samples are not finite, the first is sample {first + 1} "
            f"({samples[first]})"
        )
    if np.abs(samples).max() > LARGEST_VALUE:
        raise SignalError(f"samples above {LARGEST_VALUE:g} cannot be computed with; use another unit")
    samples.flags.writeable = False
    return samples


def checked_rate(sample_rate: float) -> float:
    """Return a sample rate, Hz, as a float."""
    if isinstance(sample_rate, bool) or not 0 < real_number("sample_rate", sample_rate, "Hz") < math.inf:
        raise SignalError(f"the sample rate must be a positive number of hertz, not {sample_rate!r}")
    return float(sample_rate)
