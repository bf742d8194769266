"""How numbers of a mechanism scatter: each by itself, or several together."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals


@dataclass(frozen=True)
class Normal:
    """A normal distribution.

    Attributes:
        mean: In the SI unit of the place.
        deviation: Standard deviation, > 0.
    """

    mean: float
    deviation: float

    def quantile(self, shares: Reals) -> Reals:
        """Return the values below which shares of all lie, of the same shape."""
        from scipy.special import ndtri

        return np.asarray(self.mean + self.deviation * ndtri(shares))


@dataclass(frozen=True)
class Uniform:
    """A uniform distribution between two values in the SI unit of the place."""

    lowest: float
    highest: float

    def quantile(self, shares: Reals) -> Reals:
        """Return the values below which shares of all lie, of the same shape."""
        return np.asarray(self.lowest + (self.highest - self.lowest) * shares)


Distribution = Normal | Uniform


@dataclass(frozen=True)
class Scatter:
    """A number with its distribution from machine to machine.

    Attributes:
        place: Its dotted place.
        unit: The SI unit.
        distribution: How it scatters.
        assumed: Whether the file only says that nobody knows it, so that its range is taken as uniform.
    """

    place: str
    unit: str
    distribution: Distribution
    assumed: bool = False


@dataclass(frozen=True)
class JointScatter:
    """Numbers that scatter together, normally.

    Attributes:
        places: Their dotted places, each of which is in ``Uncertainty.scatters`` too.
        covariance: In products of their SI units, a row for each place.
    """

    places: tuple[str, ...]
    covariance: tuple[tuple[float, ...], ...]

    @property
    def root(self) -> Reals:
        """A matrix R with R R' = covariance, (n, n); it exists for singular ones too."""
        values, vectors = np.linalg.eigh(np.array(self.covariance))
        return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0)))


@dataclass(frozen=True)
class Uncertainty:
    """All numbers that scatter.

    Attributes:
        scatters: The numbers.
        joints: Which of them scatter together; no number is in two of them.
    """

    scatters: tuple[Scatter, ...]
    joints: tuple[JointScatter, ...] = ()

    @property
    def places(self) -> tuple[str, ...]:
        """Places of all numbers."""
        return tuple(each.place for each in self.scatters)

    @property
    def independent(self) -> bool:
        """Whether no number tells anything about another."""
        return not any(np.count_nonzero(joint.covariance) > len(joint.places) for joint in self.joints)

    def values(self, shares: Reals) -> Reals:
        """Turn points of the unit cube into values.

        Args:
            shares: Points, each coordinate in (0, 1), shape (n, numbers).

        Returns:
            Values in SI units, of the same shape.
        """
        from scipy.special import ndtri

        columns = [each.distribution.quantile(shares[:, at]) for at, each in enumerate(self.scatters)]
        values = np.column_stack(columns) if columns else shares.copy()
        for joint in self.joints:
            at = [self.places.index(place) for place in joint.places]
            means = np.array([_mean(self.scatters[place].distribution) for place in at])
            values[:, at] = means + ndtri(shares[:, at]) @ joint.root.T
        return values


def _mean(distribution: Distribution) -> float:
    if isinstance(distribution, Normal):
        return distribution.mean
    return 0.5 * (distribution.lowest + distribution.highest)
