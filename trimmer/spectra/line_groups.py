"""The lines of a spectrum, group by group: what each is by itself, or with those that are close to it."""

import math
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Places, Reals
from trimmer.signals.band import Band
from trimmer.spectra.close_lines import SpectralLine, groups, resolve
from trimmer.spectra.lines import Lines, noise_beside, relaxed
from trimmer.spectra.spectrum import Spectrum
from trimmer.spectra.window import Window


class _Loss(NamedTuple):
    """Standard deviations of the fit to three bins over the Cramér-Rao bounds, measured in white noise."""

    frequency: float
    amplitude: float


_LOSSES = {
    Window.RECTANGULAR: _Loss(1.155, 1.10),
    Window.HANN: _Loss(1.90, 1.35),
    Window.BLACKMAN_HARRIS: _Loss(2.75, 1.50),
    Window.FLAT_TOP: _Loss(8.3, 1.85),
}


def resolved_lines(
    spectrum: Spectrum, lines: Lines, threshold: Reals, band: Band, limit: int | None
) -> list[SpectralLine]:
    """Return lines as what explains the bins around them: each by itself, or close ones together.

    Where other lines take the place of some, what leaks elsewhere changes: then all is looked at once
    more. The largest come first, at least those that are wanted.
    """
    for last in (False, True):
        found: list[SpectralLine] = []
        parted: list[tuple[Places, list[SpectralLine]]] = []
        for members in _by_size(spectrum, lines, band):
            if limit and _enough(found, limit, float(np.abs(lines.amplitudes[members]).max())):
                break
            noise = noise_beside(spectrum, lines, float(lines.places[members[0]]))
            alone = [_alone(spectrum, lines, int(each), noise) for each in members]
            these = resolve(spectrum, lines, members, noise, alone)
            found += [line for line in these if line.place * spectrum.bin_width in band]
            if max(len(these), len(members)) > 1 and all(line.resolved for line in these):
                parted.append((members, these))
        if last or not parted:
            break
        lines = _replaced(spectrum, lines, parted, threshold)
    return sorted(found, key=lambda line: -abs(line.amplitude))


def _by_size(spectrum: Spectrum, lines: Lines, band: Band) -> list[Places]:
    """Return the numbers of lines that are close to each other, the largest group first, in a band."""
    if not lines.bins.size:
        return []
    inside = [place * spectrum.bin_width in band for place in lines.places]
    found = [each for each in groups(spectrum.window, lines.places) if any(inside[i] for i in each)]
    return sorted(found, key=lambda members: -float(np.abs(lines.amplitudes[members]).max()))


def _enough(found: list[SpectralLine], limit: int, next_amplitude: float) -> bool:
    return sum(abs(line.amplitude) > next_amplitude for line in found) >= limit


def _replaced(
    spectrum: Spectrum, lines: Lines, parted: list[tuple[Places, list[SpectralLine]]], threshold: Reals
) -> Lines:
    """Put lines in the place of others, and fit the rest again; what was only their leakage goes."""
    gone = np.concatenate([members for members, _ in parted])
    rest = np.setdiff1d(np.arange(lines.bins.size), gone)
    places = np.array([line.place for _, these in parted for line in these])
    amplitudes = np.array([line.amplitude for _, these in parted for line in these])
    new = Lines(np.rint(places).astype(np.intp), places, amplitudes)
    moving = np.arange(new.bins.size + rest.size) >= new.bins.size
    lines = relaxed(spectrum, Lines.joined([new, lines[rest]]), moving)
    return lines[~moving | (np.abs(lines.amplitudes) > threshold[lines.bins])]


def _alone(spectrum: Spectrum, lines: Lines, number: int, noise: float) -> SpectralLine:
    """Return a line as it is if there is no other near it, among white noise of some deviation per sample.

    The Cramér-Rao bounds are sqrt(6)/pi noise/(amplitude sqrt(N)) bins and noise sqrt(2/N) (Rife and
    Boorstyn, 1974).
    """
    amplitude = complex(lines.amplitudes[number])
    share = noise / math.sqrt(spectrum.samples)
    loss = _LOSSES[spectrum.window]
    return SpectralLine(
        place=float(lines.places[number]),
        amplitude=amplitude,
        spread=loss.frequency * math.sqrt(6.0) / math.pi * share / abs(amplitude),
        amplitude_spread=loss.amplitude * math.sqrt(2.0) * share,
    )
