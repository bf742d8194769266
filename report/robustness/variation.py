"""What becomes of the predictions when parameters change: one at a time, and all at once.

Scatter and quantiles are those of ``trimmer.uncertainty``. Its samples of a loop tell the limit cycles of
friction-controlled play alone; the predictions compare three loops, and so are solved for each sample here.
"""

from dataclasses import asdict, dataclass
from typing import Final, final

import numpy as np

from report.robustness.predictions import QUANTITIES, PredictedValue, Predictions, predict
from trimmer import TrimmerParameters
from trimmer.parameters import parameter_table
from trimmer.uncertainty import Scatter, Uncertainty, Uniform, distribution_of

SHARE: Final = 0.1  # By how much each parameter changes, up and down
SAMPLES: Final = 500
SEED: Final = 20261122


@final
@dataclass(frozen=True)
class Effect:
    """What a quantity is with one parameter lowered and raised by ``SHARE``; ``parameter`` is its symbol."""

    parameter: str
    lowered: float
    raised: float

    @property
    def size(self) -> float:
        """Distance between the two."""
        return abs(self.raised - self.lowered)


@final
@dataclass(frozen=True)
class PredictionSensitivity:
    """A quantity at the thesis's parameters, its effects, the largest first, and nine tenths of samples."""

    quantity: PredictedValue
    nominal: float
    effects: tuple[Effect, ...]
    band: tuple[float, float]


@final
@dataclass(frozen=True)
class Variation:
    """All of it: a sensitivity for each quantity, and the predictions at random parameters.

    ``left_out`` of the samples have a loop without a stable limit cycle, and are not in ``samples``.
    """

    sensitivities: tuple[PredictionSensitivity, ...]
    samples: tuple[Predictions, ...]
    left_out: int


def vary(parameters: TrimmerParameters, samples: int) -> Variation:
    """Vary each parameter by itself, and all of them at random, a number of times.

    Raises:
        ValueError: if a loop loses its stable limit cycle when one parameter changes.
    """
    nominal = _predicted(parameters)
    ends = {
        name: tuple(_predicted(_scaled(parameters, {name: factor})) for factor in (1 - SHARE, 1 + SHARE))
        for name in asdict(parameters)
    }
    drawn = [predict(each) for each in random_parameters(parameters, samples)]
    predicted = tuple(each for each in drawn if each is not None)
    return Variation(
        tuple(_sensitivity(quantity, nominal, ends, predicted) for quantity in QUANTITIES),
        predicted,
        len(drawn) - len(predicted),
    )


def random_parameters(parameters: TrimmerParameters, count: int) -> list[TrimmerParameters]:
    """Draw parameters, each evenly and independently within ``SHARE`` of its value."""
    values = asdict(parameters)
    scatters = (
        Scatter(
            each.symbol,
            each.unit,
            Uniform((1 - SHARE) * values[each.symbol], (1 + SHARE) * values[each.symbol]),
        )
        for each in parameter_table()
    )
    scatter = Uncertainty(tuple(scatters))
    drawn = scatter.values(np.random.default_rng(SEED).random((count, len(values))))
    return [TrimmerParameters(**dict(zip(scatter.places, map(float, row), strict=True))) for row in drawn]


def _scaled(parameters: TrimmerParameters, factors: dict[str, float]) -> TrimmerParameters:
    values = asdict(parameters)
    return TrimmerParameters(**{name: factors.get(name, 1.0) * value for name, value in values.items()})


def _predicted(parameters: TrimmerParameters) -> Predictions:
    found = predict(parameters)
    if found is None:
        raise ValueError(f"{parameters} has a loop without a stable limit cycle")
    return found


def _sensitivity(
    quantity: PredictedValue,
    nominal: Predictions,
    ends: dict[str, tuple[Predictions, ...]],
    samples: tuple[Predictions, ...],
) -> PredictionSensitivity:
    effects = [Effect(name, quantity.of(low), quantity.of(high)) for name, (low, high) in ends.items()]
    found = distribution_of(np.array([quantity.of(each) for each in samples]))
    band = (found.quantiles[0].value, found.quantiles[-1].value) if found else (np.nan, np.nan)
    return PredictionSensitivity(
        quantity, quantity.of(nominal), tuple(sorted(effects, key=lambda effect: -effect.size)), band
    )
