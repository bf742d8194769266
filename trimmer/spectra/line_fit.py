"""Sines fitted to the bins around them, with noise made independent from bin to bin.

Noise in neighbouring bins is correlated, by the window's own coefficients; made independent (whitened), the
bins around a line tell as much as the samples do, and a window costs no resolution.

Sources: G. H. Golub and V. Pereyra, Separable nonlinear least squares, 2003; S. M. Kay, Fundamentals of
Statistical Signal Processing: Estimation Theory, 1993, chapter 3.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import combinations

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.spectra.lines import Lines, leakage
from trimmer.spectra.spectrum import Spectrum
from trimmer.spectra.window import Window

LINKED = 6  # Bins up to which lines are fitted together, at least
REACH = 6  # Bins beyond the main lobe, on either side, in which a line is held against what is there
ROUNDING = 1e-11  # Share of the largest line below which what is left of a fit is rounding
STEP = 1e-4  # Bins between places of which a derivative is taken
STEPS, LONGEST, SETTLED = 15, 0.7, 1e-6
"""Steps of a fit at most; how far, in bins, a place may go in one; change of the misfit at which it ends."""
PAIRS = np.arange(-3.0, 3.1, 0.4)  # Places around a line, in bins, of which pairs are tried
BETWEEN = 0.25  # Bins between places at which another line is tried


@dataclass(frozen=True, eq=False)
class LineFit:
    """Sines fitted to the bins around lines."""

    places: Reals  # In bins, rising, (k,)
    amplitudes: Complexes  # Complex, (k,)
    left: Reals  # What they leave, whitened, real parts before imaginary ones, (2 m,)
    slopes: Reals  # Its derivative by places, then by real and imaginary parts of each amplitude, (2 m, 3 k)

    @property
    def misfit(self) -> float:
        """Sum of squares in units of the variance of the noise."""
        return float(self.left @ self.left)

    @property
    def explains(self) -> bool:
        """Whether no more is left than noise leaves, whose level is known to some tenths.

        What small changes of the sines can make up for does not count.
        """
        q, _ = np.linalg.qr(self.slopes)
        free = max(len(self.left) - self.slopes.shape[1], 1)
        return bool(
            self.misfit - float(((q.T @ self.left) ** 2).sum()) < 1.5 * (free + 5.0 * np.sqrt(2.0 * free))
        )

    @cached_property
    def gains(self) -> Reals:
        """By how much the misfit rises when a sine is left out and the others move, to first order, (k,)."""
        return np.asarray((abs(self.amplitudes) / self.spreads[1]) ** 2)

    @cached_property
    def spreads(self) -> tuple[Reals, Reals]:
        """Standard deviations of places, bins, and of amplitudes, by Cramér and Rao, each (k,)."""
        count = len(self.places)
        sizes = np.linalg.norm(self.slopes, axis=0)
        inverse = np.linalg.pinv((self.slopes / sizes).T @ (self.slopes / sizes), hermitian=True)
        covariance = inverse / np.outer(sizes, sizes)
        places = np.sqrt(np.maximum(covariance.diagonal()[:count], 0.0))
        turned = (
            np.stack([self.amplitudes.real, self.amplitudes.imag], axis=1) / abs(self.amplitudes)[:, None]
        )
        parts = covariance[count:, count:]
        along = [turned[i] @ parts[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] @ turned[i] for i in range(count)]
        return places, np.sqrt(np.maximum(along, 0.0))


@dataclass(frozen=True, eq=False)
class Bins:
    """Bins around lines that are close to each other."""

    spectrum: Spectrum  # The spectrum
    bins: Places  # Numbers of the bins, (m,)
    data: Complexes  # What other lines leave there, (m,)
    # Makes noise in the bins independent and of variance 1 in real and imaginary parts, (m, m)
    whitener: Reals

    def left_by(self, places: Reals, amplitudes: Complexes) -> Complexes:
        """Return what sines leave of the data, not whitened, (m,)."""
        lines = Lines(places.astype(np.intp), places, amplitudes)
        return np.asarray(self.data - leakage(self.spectrum, lines, self.bins))

    @cached_property
    def target(self) -> Reals:
        """The data, whitened."""
        return self._whitened(self.data)

    def _whitened(self, values: Complexes) -> Reals:
        return np.concatenate([self.whitener @ values.real, self.whitener @ values.imag])

    def _shown(self, places: Reals) -> tuple[Reals, Reals]:
        """Return what sines of amplitudes 1 and j at places show, whitened, each (2 m, k)."""
        signed = np.concatenate([places, -places])
        shape = self.spectrum.window.transform(np.subtract.outer(self.bins, signed), self.spectrum.samples)
        itself, mirrored = np.split(shape, 2, axis=1)
        return self._whitened(itself + mirrored), self._whitened(1j * (itself - mirrored))

    def _columns(self, places: Reals) -> Reals:
        """Return the columns of ``_shown`` side by side, (2 m, 2 k)."""
        columns: Reals = np.stack(self._shown(places), axis=-1).reshape(2 * len(self.bins), -1)
        return columns

    def at(self, places: Reals) -> LineFit:
        """Return the sines at places whose amplitudes leave least."""
        every = self._columns(np.concatenate([places, places + STEP, places - STEP]))
        columns, ahead, behind = np.split(every, 3, axis=1)
        parts, *_ = np.linalg.lstsq(columns, self.target, rcond=None)
        slopes = ((ahead - behind) / (2.0 * STEP) * parts).reshape(len(columns), -1, 2).sum(axis=2)
        amplitudes = parts[::2] + 1j * parts[1::2]
        return LineFit(places, amplitudes, self.target - columns @ parts, np.hstack([slopes, columns]))

    def refined(self, places: Reals) -> LineFit:
        """Return the sines near places that leave least, by Levenberg's and Marquardt's method."""
        fit, damping = self.at(places), 1e-3
        for _ in range(STEPS):
            # Amplitudes are free: only what they cannot make up for moves the places (Golub and Pereyra).
            count = len(places)
            q, _ = np.linalg.qr(fit.slopes[:, count:])
            slopes = fit.slopes[:, :count] - q @ (q.T @ fit.slopes[:, :count])
            normal = slopes.T @ slopes
            normal[np.diag_indices(count)] *= 1.0 + damping
            step = np.linalg.lstsq(normal, slopes.T @ fit.left, rcond=1e-14)[0]
            step *= min(1.0, LONGEST / max(float(abs(step).max()), LONGEST))
            trial = self.at(np.clip(fit.places + step, self.bins[0], self.bins[-1]))
            gain = fit.misfit - trial.misfit
            damping *= 0.1 if gain > 0.0 else 10.0
            if gain > 0.0:
                fit = trial
            if abs(gain) < SETTLED * (1.0 + fit.misfit) and (gain > 0.0 or damping > 1.0):
                break
        return fit

    def promise(self, fit: LineFit) -> tuple[float, float]:
        """Return by how much another sine lowers the misfit about, and its place.

        The places of those that are there may move a little.
        """
        q, _ = np.linalg.qr(fit.slopes)
        places = np.arange(self.bins[0] + BETWEEN, self.bins[-1], BETWEEN)
        first, second = (each - q @ (q.T @ each) for each in self._shown(places))
        aa, ab, bb = (first**2).sum(axis=0), (first * second).sum(axis=0), (second**2).sum(axis=0)
        a, b = first.T @ fit.left, second.T @ fit.left
        determinant = aa * bb - ab**2
        good = determinant > 1e-12 * (aa + bb) ** 2
        gains = np.zeros(len(places))
        gains[good] = ((bb * a**2 - 2.0 * ab * a * b + aa * b**2) / np.where(good, determinant, 1.0))[good]
        best = int(np.argmax(gains))
        return float(gains[best]), float(places[best])

    def pairs(self, around: float) -> Iterator[Reals]:
        """Yield the pairs of places around a line that leave least, on a grid."""
        grid = around + PAIRS
        grid = grid[(grid > self.bins[0]) & (grid < self.bins[-1])]
        both = np.array(list(combinations(range(len(grid)), 2)))
        columns = self._columns(grid).reshape(len(self.target), -1, 2)
        of_pairs = columns[:, both].reshape(len(self.target), len(both), 4).transpose(1, 0, 2)
        q, _ = np.linalg.qr(of_pairs)
        gains = ((q.transpose(0, 2, 1) @ self.target) ** 2).sum(axis=1)
        for best in np.argsort(-gains)[:3]:
            yield grid[both[best]]


@cache
def _correlation(window: Window, count: int) -> Reals:
    """Return how noise in neighbouring bins is correlated, (count, count)."""
    sides = np.array(window.value) * (-1.0) ** np.arange(len(window.value))
    two_sided = np.concatenate([sides[:0:-1] / 2, sides[:1], sides[1:] / 2])
    lags = np.correlate(two_sided, two_sided, "full")[len(two_sided) - 1 :]
    row = np.zeros(count)
    row[: min(count, len(lags))] = lags[:count] / lags[0]
    return np.asarray(row[abs(np.subtract.outer(np.arange(count), np.arange(count)))])


def linked(window: Window) -> int:
    """Return up to how many bins apart lines are close to each other."""
    return max(LINKED, window.half_width + 2)


def bins_around(spectrum: Spectrum, lines: Lines, members: Places, noise: float) -> Bins:
    """Return the bins around some of all lines, without what the others show there.

    They end half way to others that are close but not fitted with them, whose misfit is not theirs.
    """
    window = spectrum.window
    reach, last = window.half_width + REACH, spectrum.lines.size - 2
    others = np.setdiff1d(np.arange(lines.bins.size), members)
    ends = float(lines.places[members].min()), float(lines.places[members].max())
    below, above = (
        min((gap for gap in gaps if 0.0 <= gap <= linked(window)), default=2.0 * reach) / 2.0
        for gaps in (ends[0] - lines.places[others], lines.places[others] - ends[1])
    )
    low = max(round(ends[0] - below), window.half_width)
    high = min(round(ends[1] + above), last)
    bins = np.arange(low, high + 1)
    data = spectrum.lines[bins] - leakage(spectrum, lines[others], bins)
    variance = 2.0 * noise**2 * window.noise_bandwidth / spectrum.samples
    rounding = (ROUNDING * float(abs(lines.amplitudes).max())) ** 2
    covariance = variance * _correlation(window, len(bins)) + rounding * np.eye(len(bins))
    whitener = np.linalg.inv(np.linalg.cholesky(covariance))
    return Bins(spectrum, bins, data, whitener)
