"""Measured lines made by hand."""

import numpy as np

from trimmer import Signal
from trimmer.fitting.measured import MeasuredLines
from trimmer.fitting.stray import StrayLine


def measured(
    lines: np.ndarray,
    factors: np.ndarray | None = None,
    *,
    freedom: float = 50.0,
    periods: float = 100.0,
    period_count: int = 1,
    strays: tuple[StrayLine, ...] = (),
    noiseless: bool = False,
) -> MeasuredLines:
    """Return lines, (m, outputs), whose drive of 50 Hz lasts some periods; by default with a noise of 1."""
    count, outputs = lines.shape
    samples = round(20 * periods)
    signals = {f"s{place}": Signal(np.zeros(samples), 1000.0, f"s{place}", "m") for place in range(outputs)}
    unit = np.broadcast_to(np.eye(outputs, dtype=complex), (count, outputs, outputs))
    used = unit if factors is None else factors
    return MeasuredLines(signals, 50.0, True, period_count, lines, used, freedom, strays, noiseless)
