"""What a pin or a force does over a period of what drives it: a constant, and waves.

A waveform is known by samples over a period. It is the trigonometric polynomial of them up to an order, which
is their discrete Fourier series, cut off.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from trimmer.mechanism.number_table import TableError, columns_of
from trimmer.mechanism.parts import Force, Pin
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import is_number

if TYPE_CHECKING:
    from trimmer.arrays import Complexes

ORDERS = 20  # Orders of a waveform that are taken if no number is given
FEWEST, MOST = 3, 100_000  # Samples of a waveform
UNEVEN = 0.01  # By how much of their distance phases may be off, as in rounded text
ROUNDING = 1e-14  # Share of the largest amplitude of a waveform below which another is rounding


class Wave(NamedTuple):
    """amplitude sin(order w t + phase); the order is whole, but in those of another drive's frequency."""

    order: float
    amplitude: float
    phase: float


def waves_of(part: Pin | Force, omega: float) -> tuple[Wave, ...]:
    """Return the waves of a pin, m, or of a force, N, that are driven at omega, rad/s."""
    unbalance = part.unbalance * (part.order * omega) ** 2 if isinstance(part, Force) else 0.0
    own = Wave(part.order, part.amplitude + unbalance, part.phase)
    given = (Wave(int(order), amplitude, phase) for order, amplitude, phase in part.harmonics or ())
    waveform = _of_samples(part.waveform, _orders(part)) if part.waveform else ()
    return tuple(each for each in (own, *given, *waveform) if each.amplitude)


def reach_of(part: Pin | Force) -> float:
    """Return a bound of what the waves of a part do, m of a pin, N of a force without its unbalance."""
    return sum(abs(each.amplitude) for each in waves_of(part, 0.0))


def mean_of(part: Pin | Force) -> float:
    """Return what a part does in the mean over a period, without a velocity: m of a pin, N of a force."""
    import numpy as np

    constant = part.offset if isinstance(part, Pin) else part.constant
    return constant + float(np.mean(part.waveform)) if part.waveform else constant


def is_driven(part: Pin | Force) -> bool:
    """Say whether a part needs a frequency."""
    return bool(waves_of(part, 1.0))


def left_out(part: Pin | Force) -> float:
    """Return the rms of what is left out of a waveform, over that of its samples about their mean."""
    import numpy as np

    samples = np.array(part.waveform or (0.0,))
    spectrum = abs(np.fft.rfft(samples - samples.mean())) ** 2
    # Both signs of a frequency count; that of half the sampling rate has but one.
    spectrum[1 : (len(samples) + 1) // 2] *= 2.0
    whole = float(spectrum.sum())
    return float(np.sqrt(spectrum[_orders(part) + 1 :].sum() / whole)) if whole else 0.0


def _orders(part: Pin | Force) -> int:
    highest = (len(part.waveform or ()) - 1) // 2
    return min(ORDERS, highest) if part.orders is None else part.orders


@lru_cache(maxsize=64)
def _of_samples(samples: tuple[float, ...], orders: int) -> tuple[Wave, ...]:
    import numpy as np

    series: Complexes = 2.0 * np.fft.rfft(samples)[: orders + 1] / len(samples)
    least = ROUNDING * abs(series).max()
    return tuple(
        Wave(order, float(abs(each)), float(np.angle(each) + np.pi / 2))
        for order, each in enumerate(series[1:], start=1)
        if abs(each) > least
    )


def samples_of(place: tuple[str, ...], value: object, folder: Path, problems: list[Problem]) -> object:
    """Return the samples of a waveform of a file: those of the table that it names, or that stand there."""
    if not isinstance(value, str):
        return value
    try:
        columns = columns_of(folder / value)
    except TableError as error:
        problems.append(Problem(place, str(error), value))
        return None
    if reason := _reason_against(columns):
        problems.append(Problem(place, reason, value))
        return None
    return columns["value"].tolist()


def _reason_against(columns: dict[str, Any]) -> str:
    import numpy as np

    if set(columns) != {"phase", "value"}:
        return f"the table has the columns {', '.join(columns)}; it needs phase and value, and no other"
    phases = columns["phase"]
    count = len(phases)
    if count > 1 and abs(phases[-1] - 1.0) <= UNEVEN / count:
        return "the phase 1 is the phase 0 again; leave its line out"
    if (abs(phases * count - np.arange(count)) > UNEVEN).any():
        return f"the phases must be evenly spaced from 0 on: 0, 1/{count}, 2/{count}, ... before 1"
    return ""


def problems_of_waveform(place: tuple[str, ...], part: Any) -> Iterator[Problem]:
    """Find samples that are none, and orders that they do not have."""
    samples, orders = part.waveform, part.orders
    if samples is None:
        if orders is not None:
            yield Problem((*place, "orders"), "only a waveform has orders; leave it out", orders)
        return
    there = (*place, "waveform")
    if not isinstance(samples, list | tuple) or not all(map(is_number, samples)):
        yield Problem(there, 'name a table of phase and value, as in "cam.csv"', samples)
    elif not FEWEST <= len(samples) <= MOST:
        yield Problem(there, f"has {len(samples)} samples; give {FEWEST} to {MOST}")
    elif not all(map(math.isfinite, samples)):
        yield Problem(there, "all samples must be finite")
    elif orders is not None:
        highest = (len(samples) - 1) // 2
        if not isinstance(orders, int) or isinstance(orders, bool) or not 1 <= orders <= highest:
            reason = f"{len(samples)} samples have the orders 1 to {highest}; give a whole number of these"
            yield Problem((*place, "orders"), reason, orders)
