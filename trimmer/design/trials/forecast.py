"""A forecast of measures over two numbers, from trials over each alone: where it is worth to try both.

The logarithm of a measure is taken as a sum of one function of each number, straight between the trials. It
only says where to try; what is recommended was computed.
"""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.design.specification.targets import OF_CLOSING, OF_STEP, Measure, Target
from trimmer.design.trials.trial import Trial

GRID = 81  # Values of each number at which a forecast is made, twice: over the range, then around the best
AMPLE = 0.4  # Margin beyond which more is no better, so that the smaller change is taken
EFFORT = 0.02  # What a change by the factor e costs of the margin
NEAR = 0.25
"""Distance, as a logarithm, to a trial whose motion did not repeat as wanted, within which none is tried."""
SMALLEST = 1e-3  # Share of its bound below which a measure counts as this


@dataclass(frozen=True, eq=False)
class Scan:
    """Trials over one number."""

    # place, unit: Dotted place and SI unit of the number
    place: str
    unit: str
    value: float  # The number of the file
    factors: Reals  # Logarithms of its factors, rising, (n,)
    logs: Reals  # Logarithms of what each target bounds, (n, targets)
    regular: Flags  # Whether the motion was found, and repeats as wanted, (n,)
    trials: tuple[Trial, ...]  # What was computed, in the same order

    def at(self, factors: Reals) -> tuple[Reals, Flags]:
        """Return logarithms of measures, (m, targets), and whether the motion is regular, (m,)."""
        columns = [np.interp(factors, self.factors, column) for column in self.logs.T]
        regular = np.interp(factors, self.factors, self.regular.astype(float)) > 0.999
        return np.stack(columns, axis=-1), regular

    def grid(self, around: float | None = None) -> Reals:
        """Return values of the factor over the range, or around one of them."""
        if around is None:
            return np.linspace(self.factors[0], self.factors[-1], GRID)
        reach = (self.factors[-1] - self.factors[0]) / (GRID - 1)
        near = np.linspace(around - reach, around + reach, GRID // 4)
        return np.clip(near, self.factors[0], self.factors[-1])


def scan_of(
    place: str, unit: str, value: float, trials: tuple[Trial, ...], targets: tuple[Target, ...]
) -> Scan:
    """Return trials over one number, whose values are those of the number alone, in rising order."""
    return Scan(
        place,
        unit,
        value,
        np.log([each.values[0] / value for each in trials]),
        np.array([logs_of(each, targets) for each in trials]),
        np.array([is_regular(each, targets) for each in trials]),
        trials,
    )


def logs_of(trial: Trial, targets: tuple[Target, ...]) -> Reals:
    """Return the logarithm of what each target bounds, in units of its bound, (targets,)."""
    found = []
    for each in targets:
        value = trial.value(each.measure, each.part) / (each.bound or 1e-12)
        known = np.isfinite(value) and each.measure is not Measure.PERIOD
        found.append(np.log(max(value, SMALLEST)) if known else 0.0)
    return np.array(found)


def is_regular(trial: Trial, targets: tuple[Target, ...]) -> bool:
    """Say whether a motion was found, and repeats as it is wanted to, or its contacts close."""
    closes = all(
        math.isfinite(trial.value(each.measure, each.part))
        for each in targets
        if each.measure in (*OF_CLOSING, *OF_STEP)
    )
    return closes and trial.meets(tuple(each for each in targets if each.measure is Measure.PERIOD))


@dataclass(frozen=True, eq=False)
class Forecast:
    """The forecast over one number or two."""

    targets: tuple[Target, ...]  # What is wanted
    scans: tuple[Scan, ...]  # Trials over each number alone
    nominal: Reals  # Logarithms of what the targets bound at the file's own point, (targets,)
    regular: bool  # Whether the motion there repeats as wanted

    def best(self, offset: Reals, avoided: tuple[Reals, ...] = ()) -> tuple[Reals, float]:
        """Return the factors, as logarithms, with the largest margin of all targets, and that margin.

        Trials have shown the offset, (targets,), of the logarithms, and factors, (numbers,), around
        which the motion did not repeat as wanted.
        """
        first, _ = self._best_of([each.grid() for each in self.scans], offset, avoided)
        grids = [each.grid(float(at)) for each, at in zip(self.scans, first, strict=True)]
        return self._best_of(grids, offset, avoided)

    def logs(self, factors: Reals) -> Reals:
        """Return the forecast at factors, (numbers,), as logarithms, (targets,)."""
        rows = [each.at(np.array([at]))[0][0] for each, at in zip(self.scans, factors, strict=True)]
        return np.asarray(self.nominal + sum(row - self.nominal for row in rows))

    def _best_of(self, grids: list[Reals], offset: Reals, avoided: tuple[Reals, ...]) -> tuple[Reals, float]:
        mesh = np.meshgrid(*grids, indexing="ij")
        logs = np.broadcast_to(self.nominal + offset, (*mesh[0].shape, len(self.targets))).copy()
        flags = []
        for axis, (scan, grid) in enumerate(zip(self.scans, grids, strict=True)):
            found, regular = scan.at(grid)
            shape = [1] * len(grids)
            shape[axis] = len(grid)
            logs += (found - self.nominal).reshape(*shape, -1)
            flags.append(np.broadcast_to(regular.reshape(shape), mesh[0].shape))
        # Two numbers that each leave a motion regular are taken to do so together; and one that mends it, to
        # mend it whatever the other does.
        regular = np.logical_and.reduce(flags) if self.regular else np.logical_or.reduce(flags)
        margin = np.where(regular, self._margins(logs).min(axis=-1), -1.0)
        for each in avoided:
            gone = sum((axis - at) ** 2 for axis, at in zip(mesh, each, strict=True)) < NEAR**2
            margin = np.where(gone, -1.0, margin)
        effort = EFFORT * sum(abs(axis) for axis in mesh)
        place = np.unravel_index(int(np.argmax(np.minimum(margin, AMPLE) - effort)), margin.shape)
        return np.array([axis[place] for axis in mesh]), float(margin[place])

    def _margins(self, logs: Reals) -> Reals:
        shares = np.exp(np.minimum(logs, 5.0))
        columns = []
        for at, target in enumerate(self.targets):
            share = shares[..., at]
            if target.measure is Measure.PERIOD:
                columns.append(np.ones_like(share))
            else:
                columns.append(np.clip(share - 1 if target.at_least else 1 - share, -1.0, 1.0))
        return np.stack(columns, axis=-1)
