"""The thesis's loop with linear parameters at random: whether it has limit cycles, and at which frequency."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any, Final

import numpy as np
from scipy.stats import spearmanr

from report.numbers.future_work.kept import KeptAnswer
from report.numbers.future_work.load import response
from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles
from trimmer.arrays import Reals

FACTORS: Final = (1.1, 1.5, 3.0, 10.0)
"""Each parameter is drawn between its value over a factor and times it, evenly in its logarithm."""
SAMPLES, SEED = 300, 64
NAMES: Final = tuple(asdict(TrimmerParameters.thesis()))


def drawn(factor: float, count: int = SAMPLES) -> tuple[Reals, list[TrimmerParameters]]:
    """Return logarithms of what the parameters are multiplied with, (count, 13), and the parameters."""
    logs = np.log(factor) * np.random.default_rng(SEED).uniform(-1, 1, (count, len(NAMES)))
    values = np.array(list(asdict(TrimmerParameters.thesis()).values())) * np.exp(logs)
    return logs, [TrimmerParameters(**dict(zip(NAMES, row, strict=True))) for row in values.tolist()]


def sample_row(parameters: TrimmerParameters) -> list[Any]:
    """Return numbers of limit cycles and of stable ones, frequency (Hz) and amplitude of the largest."""
    found = limit_cycles(response(parameters), FrictionBacklash(1.0))
    stable = [each for each in found if each.stable]
    largest = max(stable, key=lambda each: each.amplitude, default=None)
    return [len(found), len(stable), *((largest.frequency, largest.amplitude) if largest else (None, None))]


def ranks(logs: Reals, rows: list[list[Any]]) -> Iterator[list[Any]]:
    """Yield each parameter and its rank correlations with having a stable limit cycle and its frequency."""
    stable = np.array([row[1] > 0 for row in rows])
    frequency = np.array([row[2] for row in rows if row[1]])
    for place, name in enumerate(NAMES):
        exists = 0.0 if stable.all() else float(spearmanr(logs[:, place], stable).statistic)
        yield [name, exists, float(spearmanr(logs[stable, place], frequency).statistic)]


def _computed() -> dict[str, Any]:
    content: dict[str, Any] = {}
    for factor in FACTORS:
        logs, parameters = drawn(factor)
        rows = [sample_row(each) for each in parameters]
        content |= {f"samples {factor:g}": rows, f"ranks {factor:g}": list(ranks(logs, rows))}
    return content


SCATTER: Final = KeptAnswer("scatter", [FACTORS, SAMPLES, SEED], _computed)
