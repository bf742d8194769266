"""What in a record makes its spectrum doubtful: clipping, too low a sample rate, too short a record."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from trimmer.arrays import Reals
from trimmer.spectra.classification import Origin
from trimmer.spectra.spectrum import Spectrum

_CLIPPED_SHARE = 0.005
"""Share of the samples that have the extreme value, from which on they count as clipped."""

_CLIPPED_EXCESS = 3.0
"""How many times more samples have the extreme value than the next one, in a clipped record.

Coarse steps of a converter put many samples on the extreme value as well, but nearly as many on the next.
"""

_SAME = 1e-9
"""Relative difference below which two frequencies are the same, so that no record tells them apart."""


def clipping_doubt(values: Reals) -> str | None:
    """Say whether many samples in a row have the extreme value, as where a measurement is clipped.

    Args:
        values: Samples, shape (n,).
    """
    ends = [(name, _clipped(sign * values)) for name, sign in (("largest", 1.0), ("smallest", -1.0))]
    clipped = [f"{count} of {values.size} samples have the {name} value" for name, count in ends if count]
    if not clipped:
        return None
    return (
        f"{' and '.join(clipped)}: if the measurement is clipped there, harmonics are seen that the motion "
        "does not have; measure again with a larger range"
    )


def _clipped(values: Reals) -> int:
    """Count the samples of the largest value if they look clipped, else 0."""
    highest = values == values.max()
    count, others = int(highest.sum()), values[~highest]
    in_a_row = bool((highest[1:] & highest[:-1]).any())
    if not in_a_row or others.size == 0 or count < max(3.0, _CLIPPED_SHARE * values.size):
        return 0
    return count if count > _CLIPPED_EXCESS * int((others == others.max()).sum()) else 0


def aliasing_doubt(drive: float, sample_rate: float) -> str | None:
    """Say whether a drive (Hz) is too fast for a sample rate (Hz), and where it shows then."""
    if 2.0 * drive < sample_rate:
        return None
    shown = abs(drive - round(drive / sample_rate) * sample_rate)
    return (
        f"the drive at {drive:g} Hz is not below half of the sample rate, {0.5 * sample_rate:g} Hz, and "
        f"shows at {shown:g} Hz in the samples; a sample rate of more than {2.0 * drive:g} Hz is needed"
    )


def resolution_doubts(spectrum: Spectrum, drive: float | None, origins: Sequence[Origin]) -> Iterator[str]:
    """Say what is too close in frequency for the length of a record.

    Args:
        spectrum: Spectrum of the record.
        drive: Frequency of the drive, Hz; None without one.
        origins: What peaks may be, and shall be distinguished.
    """
    needed = spectrum.window.parted
    duration = 1.0 / spectrum.bin_width
    if drive is not None and drive < needed * spectrum.bin_width:
        yield (
            f"the record of {duration:.4g} s holds {drive * duration:.3g} periods of the drive, so the "
            f"peaks of its harmonics run into one another; {needed / drive:.4g} s or more are needed"
        )
    ordered = sorted(origins, key=lambda origin: origin.frequency)
    for lower, upper in pairwise(ordered):
        apart = upper.frequency - lower.frequency
        if _SAME * upper.frequency < apart < needed * spectrum.bin_width:
            yield (
                f"{lower.label} at {lower.frequency:.6g} Hz and {upper.label} at {upper.frequency:.6g} Hz "
                f"are {apart / spectrum.bin_width:.2g} bins apart, which a record of {duration:.4g} s does "
                f"not part; {needed / apart:.4g} s or more are needed"
            )


def doubts(
    values: Reals, spectrum: Spectrum, drive: float | None, origins: Sequence[Origin]
) -> tuple[str, ...]:
    """Say in sentences without a full stop what makes a spectrum doubtful; none if nothing does."""
    clipping = clipping_doubt(values)
    return (*filter(None, [clipping]), *resolution_doubts(spectrum, drive, origins))
