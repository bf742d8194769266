"""M/D of the load behind the play from the frequency of a limit cycle: curves, intervals, and shifts."""

from dataclasses import asdict
from typing import Any, Final

import numpy as np

from report.numbers.future_work.kept import KeptAnswer
from trimmer import (
    FrictionBacklash,
    TrimmerParameters,
    ViscousBacklash,
    identify_time_constant,
    limit_cycles,
    transfer_function,
)
from trimmer.linear import InputChannels

TIMES: Final = (1e-6, 1.0, 73)  # M/D of the curves, s: first, last, how many, evenly on a logarithmic scale
MEASURED: Final = (734.0, 737.0, 740.0, 745.0, 750.0)  # Frequencies as if measured, Hz
RECORDS: Final = (0.1, 1.0, 10.0)
"""Lengths of the records, s; half a bin, 1/(2T), is the uncertainty of a peak."""
TOLERANCE: Final = 0.01  # By how much each parameter may be off, either way
SAMPLES, SEED = 60, 40


def response(parameters: TrimmerParameters) -> Any:
    """Return G from the pin's displacement alone, as section 5.2 has it."""
    return transfer_function(parameters, channels=InputChannels.DISPLACEMENT_ONLY)


def curve_rows() -> list[list[Any]]:
    """Return M/D (s), frequency (Hz), amplitude in gaps, stability of each limit cycle."""
    system, (first, last, count) = response(TrimmerParameters.thesis()), TIMES
    return [
        [time, cycle.frequency, cycle.amplitude, cycle.stable]
        for time in np.geomspace(first, last, count).tolist()
        for cycle in limit_cycles(system, ViscousBacklash(1.0, time))
    ]


def interval_row(frequency: float, record: float) -> list[Any]:
    """Return frequency (Hz), length of the record (s), lowest and highest M/D (s); None for infinity."""
    system = response(TrimmerParameters.thesis())
    found = identify_time_constant(system, 1.0, frequency, frequency_uncertainty=0.5 / record)
    ends = [(each.lowest, each.highest) for each in found.intervals]
    low, high = min(low for low, _ in ends), max(high for _, high in ends)
    return [frequency, record, low, None if np.isinf(high) else high]


def shifted() -> list[list[Any]]:
    """Return lower and upper end of the stable band (Hz), with parameters at random within ``TOLERANCE``."""
    values = asdict(TrimmerParameters.thesis())
    draw, rows = np.random.default_rng(SEED), []
    for _ in range(SAMPLES):
        factors = 1 + TOLERANCE * draw.uniform(-1, 1, len(values))
        changed = {name: float(value * by) for (name, value), by in zip(values.items(), factors, strict=True)}
        system = response(TrimmerParameters(**changed))
        ends = (FrictionBacklash(1.0), ViscousBacklash(1.0, TIMES[1]))
        rows.append([max(c.frequency for c in limit_cycles(system, end) if c.stable) for end in ends])
    return rows


LOAD: Final = KeptAnswer(
    "load",
    [TIMES, MEASURED, RECORDS, TOLERANCE, SAMPLES, SEED],
    lambda: {
        "curves": curve_rows(),
        "intervals": [interval_row(frequency, record) for frequency in MEASURED for record in RECORDS],
        "shifted": shifted(),
    },
)
