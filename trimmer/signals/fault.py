"""A fault of a record, and how sure it is: clipping, a dropout, few steps, a large offset."""

from dataclasses import dataclass
from typing import ClassVar, final

from trimmer.choices import Choice


class FaultCertainty(Choice):
    """How sure a fault is."""

    CERTAIN = "certain"
    LIKELY = "likely"
    POSSIBLE = "possible"


@final
@dataclass(frozen=True)
class Clipping:
    """Runs of samples that have the extreme value.

    Attributes:
        certainty: ``CERTAIN`` at the full scale of the device; ``LIKELY`` if there are several, or both
            extremes have the same modulus, and the signal is cut off in most; else ``POSSIBLE``: the motion
            itself may stand still there, as in stick, into which it comes smoothly.
        largest, smallest: Number of samples that have the largest and the smallest value, 0 without runs.
        runs: Number of runs of both.
        samples: Number of samples of the record.
        first: Time of the first run, s.
        level: The largest modulus of the clipped values, in the unit of the signal.
    """

    certainty: FaultCertainty
    largest: int
    smallest: int
    runs: int
    samples: int
    first: float
    level: float
    kind: ClassVar[str] = "clipping"
    """The fault in a word or two."""

    @property
    def sentence(self) -> str:
        """What was found and what it means, without a full stop."""
        ends = (("largest", self.largest), ("smallest", self.smallest))
        told = [f"{n} of {self.samples} samples have the {name} value" for name, n in ends if n]
        found = f"{' and '.join(told)}, in {self.runs} run{'s' * (self.runs > 1)} from {self.first:.6g} s on"
        if self.certainty is FaultCertainty.CERTAIN:
            return f"{found}: the measurement is clipped at full scale {_REMEDY}"
        if self.certainty is FaultCertainty.LIKELY:
            return f"{found}: the measurement is likely to be clipped there {_REMEDY}"
        return f"{found}: if the motion does not stand still there, the measurement is clipped {_REMEDY}"


_REMEDY = "and shows harmonics that the motion does not have; measure again with a larger range"


@final
@dataclass(frozen=True)
class Dropout:
    """A long run of equal samples where the signal moves elsewhere.

    Attributes:
        begin, end: Times of the first and the last of them, s.
        value: The value, in the unit of the signal.
        samples: Number of samples.
        others: Number of further runs of that kind.
    """

    begin: float
    end: float
    value: float
    samples: int
    others: int
    kind: ClassVar[str] = "dropout"
    """The fault in a word or two."""

    @property
    def sentence(self) -> str:
        """What was found and what it means, without a full stop."""
        more = f" (as {self.others} more)" if self.others else ""
        return (
            f"{self.samples} samples from {self.begin:.6g} s to {self.end:.6g} s are exactly "
            f"{self.value:.6g}{more}: a dropout of the measurement, unless the motion stands still there; "
            "leave it out (--from, --until)"
        )


@final
@dataclass(frozen=True)
class FewSteps:
    """Samples that have few different values.

    Attributes:
        values: Number of different values.
        step: Smallest difference of two of them, in the unit of the signal.
        bits: Logarithm to base 2 of the range in steps.
        noise: Root mean square of the rounding, step/sqrt(12), in the unit of the signal.
        unit: That unit.
    """

    values: int
    step: float
    bits: float
    noise: float
    unit: str
    kind: ClassVar[str] = "few steps"
    """The fault in a word or two."""

    @property
    def sentence(self) -> str:
        """What was found and what it means, without a full stop."""
        return (
            f"the samples have {self.values} different values, steps of {self.step:.4g} {self.unit}".rstrip()
            + f" ({self.bits:.1f} bits used): rounding adds about {self.noise:.2g} {self.unit}".rstrip()
            + " rms, in part as lines at harmonics; use a smaller range or more bits"
        )


@final
@dataclass(frozen=True)
class Offset:
    """A mean that is large beside the vibration.

    Attributes:
        mean: Mean, in the unit of the signal.
        ratio: Its modulus over the root mean square of the rest.
        unit: The unit.
    """

    mean: float
    ratio: float
    unit: str
    kind: ClassVar[str] = "offset"
    """The fault in a word or two."""

    @property
    def sentence(self) -> str:
        """What was found and what it means, without a full stop."""
        return (
            f"the mean, {self.mean:.6g} {self.unit}".rstrip() + f", is {self.ratio:.3g} times the rms of the "
            "vibration about it: it is taken off, but takes range from the measurement"
        )


Fault = Clipping | Dropout | FewSteps | Offset
