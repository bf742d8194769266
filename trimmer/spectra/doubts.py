"""What in a record makes its spectrum doubtful: faults, too low a sample rate, too short a record."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from trimmer.signals import Band, Signal
from trimmer.signals.faults import faults
from trimmer.spectra.classification import Origin
from trimmer.spectra.close_lines import TOGETHER, chains
from trimmer.spectra.line_fit import linked
from trimmer.spectra.peaks import Peak
from trimmer.spectra.spectrum import Spectrum

_SHOWN = 5
_SAME = 1e-9
"""Relative difference below which two frequencies are the same, so that no record tells them apart."""


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
    """Say what is too close in frequency for the length of a record."""
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


def band_doubts(band: Band, peaks: Sequence[Peak]) -> Iterator[str]:
    """Name the peaks (Hz) that lie where the samples are not to be trusted."""
    outside = [f"{peak.frequency:.5g}" for peak in peaks if peak.frequency not in band]
    if outside:
        listed = ", ".join(outside[:_SHOWN]) + (", ..." if len(outside) > _SHOWN else "")
        yield f"not to be trusted: peaks at {listed} Hz; the samples are {band.sentence}"


def unsteady_doubts(peaks: Sequence[Peak]) -> Iterator[str]:
    """Name the peaks (Hz) that no steady sine explains, or several too close to each other."""
    unsteady = [
        f"{peak.frequency:.6g} ± {peak.frequency_uncertainty:.2g}" for peak in peaks if not peak.resolved
    ]
    if unsteady:
        listed = ", ".join(unsteady[:_SHOWN]) + (", ..." if len(unsteady) > _SHOWN else "")
        yield (
            f"no single steady sine explains the peaks at {listed} Hz: each is several lines that this "
            "record does not part, or one that changes in the course of it, such as a vibration that dies "
            "out; their uncertainties hold what a sine leaves there"
        )


def crowding_doubts(spectrum: Spectrum, peaks: Sequence[Peak]) -> Iterator[str]:
    """Say where more peaks are close to each other than are fitted together."""
    places = np.array([peak.frequency for peak in peaks]) / spectrum.bin_width
    for chain in chains(spectrum.window, places):
        if len(chain) > TOGETHER:
            first, last = peaks[chain[0]].frequency, peaks[chain[-1]].frequency
            yield (
                f"{len(chain)} peaks from {first:.6g} to {last:.6g} Hz have no more than "
                f"{linked(spectrum.window)} bins between neighbours; no more than {TOGETHER} of them are "
                "fitted together, and those beside a cut are a little less certain"
            )


def doubts(
    signal: Signal, spectrum: Spectrum, drive: float | None, origins: Sequence[Origin]
) -> tuple[str, ...]:
    """Say in sentences without a full stop what makes a spectrum doubtful; none if nothing does."""
    wrong = (fault.sentence for fault in faults(signal))
    return (*wrong, *resolution_doubts(spectrum, drive, origins))
