"""Frequencies at which a response is drawn: close together where it changes fast."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.linear.zero_pole_gain import ZeroPoleGain

REACH = 100.0  # How far beyond the outermost roots
EVEN, NEAR = 2000, 400  # Points in equal ratios, and around each root


def telling_frequencies(
    factored: ZeroPoleGain, limits: tuple[float, float] = (0.0, np.inf), reach: float = REACH
) -> Reals:
    """Return rising angular frequencies, rad/s, that show a response: around its roots and between them."""
    sizes = abs(factored.roots[factored.roots != 0])
    sizes = sizes if sizes.size else np.ones(1)
    lowest, highest = max(limits[0], sizes.min() / reach), min(limits[1], sizes.max() * reach)
    if not lowest < highest:
        lowest, highest = limits
    around = np.sinh(np.linspace(-6.0, 6.0, NEAR))
    width = np.maximum(abs(factored.roots.real), 1e-6 * abs(factored.roots))
    near = (factored.roots.imag[:, None] + width[:, None] * around).ravel()
    near = near[(near > lowest) & (near < highest)]
    return np.unique(np.concatenate([np.geomspace(lowest, highest, EVEN), near]))
