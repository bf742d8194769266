"""The corrected predictions of section 5.2 as functions of the parameters."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, final

import control

from report.numbers.friction_in_place import largest_force
from report.numbers.thesis import DRIVE_OMEGA, EXPERIMENT_GAP
from trimmer import (
    FrictionBacklash,
    InertiaBacklash,
    LimitCycle,
    TrimmerParameters,
    limit_cycles,
    transfer_function,
)
from trimmer.elements import Element
from trimmer.linear import InputChannels, filtering_ratio


@final
@dataclass(frozen=True)
class Cycles:
    """Limit cycles of a loop: the largest stable one, the highest unstable one if there is one, and how many.

    ``stable_count`` of the ``count`` are stable.
    """

    stable: LimitCycle
    unstable: LimitCycle | None
    stable_count: int
    count: int


@final
@dataclass(frozen=True)
class Predictions:
    """Predictions by harmonic balance for a gap of one metre, so that amplitudes are per gap."""

    friction: Cycles  # Friction-controlled backlash in the thesis's loop
    velocity: Cycles  # The same with the pin's velocity as second input
    inertia: Cycles  # Inertia-controlled backlash in the thesis's loop
    # Largest friction between cutter and guard with a limit cycle, thesis's loop, N/m; not a number if there
    # is no unstable limit cycle to meet
    force_per_gap: float
    turned: int  # Number of limit cycles in the loop whose output has the other sign
    fifth: float  # How much better the linear part passes five times 100 Hz than 100 Hz

    @property
    def band(self) -> float:
        """Width of the band of stable limit cycles between the two limits of the load, Hz."""
        return self.inertia.stable.frequency - self.friction.stable.frequency


def predict(parameters: TrimmerParameters) -> Predictions | None:
    """Predict for other parameters; None if one of the loops has no stable limit cycle."""
    thesis, both = (transfer_function(parameters, channels=channels) for channels in _CHANNELS)
    friction = _cycles(thesis, FrictionBacklash(1.0))
    velocity = _cycles(both, FrictionBacklash(1.0))
    inertia = _cycles(thesis, InertiaBacklash(1.0))
    if friction is None or velocity is None or inertia is None:
        return None
    return Predictions(
        friction,
        velocity,
        inertia,
        _force_per_gap(parameters, friction),
        len(limit_cycles(-thesis, FrictionBacklash(1.0))),
        float(filtering_ratio(thesis, DRIVE_OMEGA, 5)),
    )


def _cycles(system: control.TransferFunction, element: Element) -> Cycles | None:
    found = limit_cycles(system, element)
    stable = sorted((each for each in found if each.stable), key=lambda each: each.amplitude)
    unstable = sorted((each for each in found if not each.stable), key=lambda each: each.omega)
    if not stable:
        return None
    return Cycles(stable[-1], unstable[-1] if unstable else None, len(stable), len(found))


def _force_per_gap(parameters: TrimmerParameters, cycles: Cycles) -> float:
    if cycles.unstable is None:
        return math.nan
    return largest_force(parameters, _CHANNELS[0], cycles.unstable, cycles.stable).force_per_gap


_CHANNELS: Final = (InputChannels.DISPLACEMENT_ONLY, InputChannels.DISPLACEMENT_AND_VELOCITY)


@final
@dataclass(frozen=True)
class PredictedValue:
    """A predicted quantity: its name, its unit, decimals to show, and what it is of the predictions."""

    name: str
    unit: str
    decimals: int
    of: Callable[[Predictions], float]


def _frequency(cycle: LimitCycle | None) -> float:
    return cycle.frequency if cycle else math.nan


def _amplitude(cycle: LimitCycle | None) -> float:
    return cycle.amplitude if cycle else math.nan


QUANTITIES: Final = (
    PredictedValue("frequency, stable", "Hz", 1, lambda found: found.friction.stable.frequency),
    PredictedValue("amplitude per gap, stable", "", 2, lambda found: found.friction.stable.amplitude),
    PredictedValue("frequency, unstable", "Hz", 1, lambda found: _frequency(found.friction.unstable)),
    PredictedValue("amplitude per gap, unstable", "", 3, lambda found: _amplitude(found.friction.unstable)),
    PredictedValue(
        "frequency with the pin's velocity", "Hz", 1, lambda found: found.velocity.stable.frequency
    ),
    PredictedValue(
        "amplitude per gap with the pin's velocity", "", 2, lambda found: found.velocity.stable.amplitude
    ),
    PredictedValue("frequency, inertia-controlled", "Hz", 1, lambda found: found.inertia.stable.frequency),
    PredictedValue(
        "amplitude per gap, inertia-controlled", "", 2, lambda found: found.inertia.stable.amplitude
    ),
    PredictedValue(
        "frequency, inertia-controlled, unstable", "Hz", 1, lambda found: _frequency(found.inertia.unstable)
    ),
    PredictedValue("width of the band of frequencies", "Hz", 1, lambda found: found.band),
    PredictedValue(
        "friction that ends the limit cycle, gap 0.2 mm",
        "N",
        2,
        lambda found: EXPERIMENT_GAP * found.force_per_gap,
    ),
)
"""The corrected predictions in the order of the thesis."""
