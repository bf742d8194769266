"""Window functions, and the transform of each, which is the shape that a pure sine has in a spectrum."""

import math
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arrays import Complexes, Reals
from trimmer.choices import Choice


class Window(Choice):
    """A cosine-sum window; the value is its coefficients, for ``scipy.signal.windows.general_cosine``.

    ``RECTANGULAR`` is no window: right for a whole number of periods, with slow leakage (-13 dB) otherwise.
    ``HANN`` separates peaks 4 bins apart, with leakage of -31 dB that falls by 18 dB per octave.
    ``BLACKMAN_HARRIS`` separates peaks 8 bins apart, with leakage of -92 dB.
    ``FLAT_TOP`` shows amplitudes to 0.01 dB in the bins themselves, with peaks 10 bins wide.
    """

    RECTANGULAR = (1.0,)
    HANN = (0.5, 0.5)
    BLACKMAN_HARRIS = (0.35875, 0.48829, 0.14128, 0.01168)
    FLAT_TOP = (0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368)

    @property
    def half_width(self) -> int:
        """Half the width of the main lobe, in bins: farther from a sine there is only leakage."""
        return len(self.value)

    @property
    def parted(self) -> int:
        """How many bins two sines of like size must be apart to be seen as two, as ``peaks`` states."""
        return max(3, self.half_width + 1)

    @property
    def noise_bandwidth(self) -> float:
        """Mean square of the window over the square of its mean: equivalent noise bandwidth, bins."""
        first, *others = self.value
        return float(1.0 + 0.5 * math.fsum(other**2 for other in others) / first**2)

    def samples(self, count: int) -> Reals:
        """Evaluate the window at ``count`` samples, shape (count,), as one period of a periodic window."""
        from scipy.signal.windows import general_cosine

        return np.asarray(general_cosine(count, self.value, sym=False))

    def transform(self, bins: ArrayLike, count: int) -> Complexes:
        """Evaluate the window's Fourier transform relative to its value at 0.

        That is sum(w_n exp(-2 pi j x n / N)) / sum(w_n) at x bins, in closed form: a cosine-sum window is a
        sum of shifted Dirichlet kernels (Harris, 1978).

        Args:
            bins: Distances x from the sine, in bins, any shape.
            count: Number of samples N.

        Returns:
            Values without unit, in the shape of ``bins``; 1 at 0.
        """
        orders, weights = _shifts(self, count)
        x = np.asarray(bins, dtype=np.float64)
        x = x - count * np.rint(x / count)  # the transform has period N
        whole = np.rint(x)
        # All kernels have sin(pi x) in common, but for the sign; so it is exact near bins too.
        wave = np.sin(np.pi * (x - whole)) * (1.0 - 2.0 * (whole % 2))
        below = count * np.sin((np.pi / count) * np.subtract.outer(x, orders))
        on_bin = below == 0.0
        kernels = wave[..., None] / np.where(on_bin, 1.0, below)
        if on_bin.any():
            kernels[on_bin] = np.broadcast_to(1.0 - 2.0 * (orders % 2), below.shape)[on_bin]
        turn = (np.pi * (count - 1) / count) * x
        return np.asarray((kernels @ weights) * (np.cos(turn) - 1j * np.sin(turn)))


@cache
def _shifts(window: Window, count: int) -> tuple[Reals, Complexes]:
    """Return the shifts of the kernels that a window's transform is made of, bins, and their weights."""
    orders = np.arange(1.0 - len(window.value), len(window.value))
    sizes = np.take(window.value, np.abs(orders).astype(int)) * np.where(orders == 0, 1.0, 0.5)
    return orders, sizes / window.value[0] * np.exp(1j * np.pi * orders * ((count - 1) / count))
