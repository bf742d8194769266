"""Lines too close for the window: whether one sine explains the bins around it, or how many do.

The best fit of one sine is held against those of more: each that lowers the sum of squares, in units of the
noise, by more than noise would is accepted (the likelihood ratio). What no few steady sines explain, such as
a line that drifts or dies out, has no frequency to the accuracy that noise alone would allow.

Source: S. M. Kay, Fundamentals of Statistical Signal Processing: Detection Theory, 1998, chapter 6.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.spectra.line_fit import Bins, LineFit, bins_around, linked
from trimmer.spectra.lines import Lines
from trimmer.spectra.spectrum import Spectrum
from trimmer.spectra.window import Window

SURE = 30.0
"""Fall of the sum of squares that makes another line certain: noise alone gives it once in 10^5 peaks."""
POSSIBLE = 12.0  # Fall from which on another line is possible: noise alone gives it at one peak in twenty
MOST = 3  # Sines that are tried for a group, or one more than were found in it
TOGETHER = 24
"""Lines that are fitted together at most; of more that are close to each other, parts are fitted."""
LARGEST = 10.0
"""A line that is so many times larger than what is seen is one of several that cancel, and no real one."""
CLEAR = 3.0  # So many times larger than what is left, a line is there beside one that is no steady sine
APART = 1.0  # Bins below which two sines cannot be told from one that changes during the record


@dataclass(frozen=True)
class SpectralLine:
    """A line of a spectrum with its standard deviations."""

    place: float  # In bins
    amplitude: complex  # Complex
    spread: float  # Standard deviation of the place, bins
    amplitude_spread: float  # Of the amplitude
    resolved: bool = True  # Whether it is a steady sine, as far as the noise lets see


def chains(window: Window, places: Reals) -> list[Places]:
    """Return the numbers of lines that are close to each other, by place, chain by chain."""
    order = np.argsort(places)
    apart = np.diff(places[order]) > linked(window)
    return np.split(order, np.flatnonzero(apart) + 1)


def groups(window: Window, places: Reals) -> list[Places]:
    """Return the numbers of lines that are fitted together, group by group."""
    return [np.sort(part) for chain in chains(window, places) for part in _parts_of(chain, places)]


def _parts_of(chain: Places, places: Reals) -> list[Places]:
    """Cut a chain where its lines are farthest apart in the middle half, until no part is too long."""
    if len(chain) <= TOGETHER:
        return [chain]
    quarter = len(chain) // 4
    middle = np.diff(places[chain])[quarter:-quarter]
    first, second = np.split(chain, [quarter + 1 + int(np.argmax(middle))])
    return [*_parts_of(first, places), *_parts_of(second, places)]


def resolve(
    spectrum: Spectrum, lines: Lines, members: Places, noise: float, alone: Sequence[SpectralLine]
) -> list[SpectralLine]:
    """Return the lines that explain what is around some members, in white noise of a deviation per sample."""
    bins = bins_around(spectrum, lines, members, noise)
    largest_first = sorted(alone, key=lambda line: -abs(line.amplitude))
    if len(alone) == 1:
        seen = bins.at(lines.places[members])
        if bins.promise(seen)[0] < POSSIBLE and seen.explains:
            return list(alone)
    fits = list(_ladder(bins, np.array([line.place for line in largest_first])))
    chosen = 0
    for number in range(1, len(fits)):
        if fits[chosen].misfit - fits[number].misfit > SURE * (number - chosen):
            chosen = number
    fit = fits[chosen]
    if not fit.explains:
        return _unexplained(bins, largest_first)
    if chosen == 0 and len(alone) == 1:
        found = list(alone)
    else:
        found = [_line(bins, fit, part, largest_first) for part in _parts(fit, spectrum.window.parted)]
    # What is possible but not certain makes what is shown less certain.
    others = [each for each in fits[chosen + 1 :] if fit.misfit - each.misfit > POSSIBLE]
    return [_widened(line, others[0]) for line in found] if others else found


def _ladder(bins: Bins, found: Reals) -> Iterator[LineFit]:
    """Yield the best fits of one sine, two and more, as long as another one is promising.

    The steps up to many lines that were found are left out as far as each is certain in a fit of all.
    """
    begin = found if len(found) > MOST else found[:1]
    fit = bins.refined(begin)
    while len(begin) > 1 and fit.gains.min() < SURE:
        begin = np.delete(begin, np.argmin(fit.gains))
        fit = bins.refined(begin)
    for count in range(len(begin) + 1, max(MOST, len(found) + 1) + 1):
        yield fit
        gain, place = bins.promise(fit)
        if gain < POSSIBLE and len(found) < count:
            return
        starts = [np.append(fit.places, place)]
        if count <= len(found):
            starts.append(found[:count])
        if count == 2:
            starts += list(bins.pairs(float(found[0])))
        starts.sort(key=lambda start: bins.at(start).misfit)
        fit = min((bins.refined(start) for start in starts[:2]), key=lambda each: each.misfit)
    yield fit


def _parts(fit: LineFit, parted: float) -> list[Places]:
    """Return the numbers of the lines of a fit; together those that are too close to be told apart.

    What is no steady sine by that may be anything within what its window parts.
    """
    order = np.argsort(fit.places)
    spreads, apart = fit.spreads[0][order], np.diff(fit.places[order])
    far = apart >= np.maximum(APART, 3.0 * (spreads[1:] + spreads[:-1]))
    if not far.all():
        far &= apart >= parted
    return np.split(order, np.flatnonzero(far) + 1)


def _line(bins: Bins, fit: LineFit, part: Places, found: Sequence[SpectralLine]) -> SpectralLine:
    """Return a line of a fit, or what is seen of several that are too close.

    Then what is shown is the line that was found, as wide as their places are apart, by their sizes.
    """
    spreads, sizes = fit.spreads
    if len(part) == 1:
        (each,) = part.tolist()
        return SpectralLine(
            float(fit.places[each]), complex(fit.amplitudes[each]), float(spreads[each]), float(sizes[each])
        )
    middle = float(np.median(fit.places[part]))
    seen = min(found, key=lambda line: abs(line.place - middle))
    others = np.setdiff1d(np.arange(len(fit.places)), part)
    wide = _wide(
        bins,
        seen,
        bins.left_by(
            np.append(fit.places[others], seen.place), np.append(fit.amplitudes[others], seen.amplitude)
        ),
    )
    amplitudes = abs(fit.amplitudes[part])
    real = amplitudes < LARGEST * abs(seen.amplitude)
    weights = np.minimum(amplitudes / abs(seen.amplitude), 1.0)[real]
    reach = float((weights * abs(fit.places[part][real] - seen.place)).max(initial=0.0))
    larger = float(amplitudes[real].max(initial=0.0)) - abs(seen.amplitude)
    return replace(wide, spread=max(wide.spread, reach), amplitude_spread=max(wide.amplitude_spread, larger))


def _unexplained(bins: Bins, found: Sequence[SpectralLine]) -> list[SpectralLine]:
    """Return what was found, the largest first, where no few steady sines explain it.

    Of smaller lines those are left that are clearly larger than what all together leave.
    """
    left = bins.left_by(
        np.array([line.place for line in found]), np.array([line.amplitude for line in found])
    )
    clear = [line for line in found[1:] if abs(line.amplitude) > CLEAR * abs(left).max()]
    if len(clear) + 1 < len(found):
        return _unexplained(bins, [found[0], *clear])
    return [_wide(bins, line, left) for line in found]


def _wide(bins: Bins, line: SpectralLine, left: Complexes) -> SpectralLine:
    """Return a line that is no steady sine as wide as what is left lets it be.

    Let that be a share r of it. A small second line at a distance d leaves about its own share times d², and
    moves the first by that share times d: so by at most sqrt(r).
    """
    own = abs(line.amplitude) * math.sqrt(bins.spectrum.window.noise_bandwidth)
    off = float(np.linalg.norm(left))
    share = math.sqrt(off / math.hypot(off, own))
    return replace(
        line,
        spread=max(share, line.spread),
        amplitude_spread=max(share * abs(line.amplitude), line.amplitude_spread),
        resolved=False,
    )


def _widened(line: SpectralLine, other: LineFit) -> SpectralLine:
    """Return a line whose standard deviations hold what another fit says too."""
    nearest = int(np.argmin(abs(other.places - line.place)))
    off = float(other.places[nearest]) - line.place
    larger = float(abs(other.amplitudes[nearest])) - abs(line.amplitude)
    return replace(
        line, spread=math.hypot(line.spread, off), amplitude_spread=math.hypot(line.amplitude_spread, larger)
    )
