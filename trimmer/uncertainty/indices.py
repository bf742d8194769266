"""Which number matters: Sobol indices of first order and total ones, by SALib."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.errors import UncertaintyError
from trimmer.uncertainty.distributions import Uncertainty
from trimmer.uncertainty.points import within_cube
from trimmer.uncertainty.statistics import ROUNDING


@dataclass(frozen=True)
class Index:
    """The share of a variance that comes from one number: a Sobol index.

    Attributes:
        place: Its dotted place.
        first: From the number by itself.
        total: From the number in company of all others too.
        first_error, total_error: Half-widths of 95 % intervals, by resampling.
    """

    place: str
    first: float
    total: float
    first_error: float
    total_error: float


@dataclass(frozen=True)
class Indices:
    """Sobol indices of one quantity, the largest total one first.

    Attributes:
        indices: One for each number; empty if the quantity is the same in all samples.
        used: Blocks of samples that were used.
        blocks: All blocks.
    """

    indices: tuple[Index, ...]
    used: int
    blocks: int

    @property
    def message(self) -> str:
        """On what the indices rest, in a sentence."""
        if not self.used:
            return "It exists in no whole block of samples, so there are no indices."
        if not self.indices:
            return "It is the same in all samples, so nothing has an influence."
        if self.used < self.blocks:
            return (
                f"From {self.used} of {self.blocks} blocks, in which it exists in all samples: among these "
                "the numbers are no longer independent, and the indices only a hint."
            )
        return f"From {self.blocks} blocks of samples."


def require_independent(uncertainty: Uncertainty) -> None:
    """Check that the numbers scatter independently."""
    if not uncertainty.independent:
        raise UncertaintyError(
            "Sobol indices divide a variance among independent numbers, and [uncertainty] has a covariance: "
            "leave it out for them, or ask for samples alone"
        )


def saltelli_points(dimensions: int, blocks: int, seed: int) -> Reals:
    """Return points of the unit cube for Sobol indices, (blocks * (dimensions + 2), dimensions)."""
    if blocks & (blocks - 1):
        raise UncertaintyError(f"{blocks} blocks of samples: give a power of two, such as 512")
    points = _salib("sample").sample(_problem(dimensions), blocks, calc_second_order=False, seed=seed)
    return within_cube(points)


def indices_of(values: Reals, places: tuple[str, ...], seed: int) -> Indices:
    """Return the indices of values at ``saltelli_points``; NaN where a value does not exist."""
    rows = values.reshape(-1, len(places) + 2)
    whole = np.asarray(np.isfinite(rows).all(axis=1))
    used = rows[whole]
    if not used.size or np.ptp(used) <= ROUNDING * np.abs(used).max():
        return Indices((), int(whole.sum()), len(rows))
    found = _salib("analyze").analyze(
        _problem(len(places)), used.ravel(), calc_second_order=False, conf_level=0.95, seed=seed + 1
    )  # SALib takes a seed of 0 for none
    columns = zip(places, found["S1"], found["ST"], found["S1_conf"], found["ST_conf"], strict=True)
    indices = tuple(Index(place, *map(float, row)) for place, *row in columns)
    return Indices(tuple(sorted(indices, key=lambda each: -each.total)), int(whole.sum()), len(rows))


def indices_where(possible: Flags, values: Reals, places: tuple[str, ...], seed: int) -> Indices:
    """Return the indices of values of those points at which there is a sample."""
    whole = np.full(len(possible), np.nan)
    whole[possible] = values
    return indices_of(whole, places, seed)


def _problem(dimensions: int) -> dict[str, Any]:
    return {
        "num_vars": dimensions,
        "names": [str(number) for number in range(dimensions)],
        "bounds": [[0.0, 1.0]] * dimensions,
    }


def _salib(part: str) -> Any:
    from importlib import import_module

    try:
        return import_module(f"SALib.{part}.sobol")
    except ImportError as error:
        raise UncertaintyError(
            "Sobol indices need the package SALib: pip install 'trimmer[sensitivity]'"
        ) from error
