"""Numbers with units as a reader wants them: with a prefix that fits, and few digits."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from trimmer.mechanism.place_text import parse_place

PREFIXES = ((1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
LARGE_TOO = ("N", "N/m", "Hz", "W", "J", "N m", "N m/rad")
"""Units that take a prefix for large numbers too; a stroke of 2000 m is not one of 2 km."""
PREFIXED = (*LARGE_TOO, "m", "s", "kg", "rad", "kg m²")
FITS = 0.9995  # A prefix fits if the number is at least so many of it, so that 999.9 µm is written as 1 mm
ROUND = ("N", "W", "J")  # Units of which a tenth is still written without a prefix, as 0.5 N


@dataclass(frozen=True)
class Scale:
    """A unit for numbers: they are divided by the factor."""

    factor: float
    unit: str


INERTIAS = (Scale(1.0, "kg m²"), Scale(1e-6, "kg mm²"), Scale(1e-9, "g mm²"))
"""Units of moments of inertia; each is taken from a tenth of it on."""


def scale_for(values: Iterable[float], unit: str) -> Scale:
    """Return the unit in which numbers in an SI unit are easy to read, by the largest of them."""
    sizes = [abs(value) for value in values if math.isfinite(value)]
    largest = max(sizes, default=0.0)
    if unit not in PREFIXED or largest == 0:
        return Scale(1.0, "" if unit == "1" else unit)
    if unit == "kg":
        return Scale(1.0, "kg") if largest >= FITS else Scale(1e-3, "g")
    if unit == "kg m²":
        return next((each for each in INERTIAS if largest >= 0.1 * each.factor), INERTIAS[-1])
    allowed = [each for each in PREFIXES if each[0] <= 1 or unit in LARGE_TOO]
    if unit == "Hz" or (unit in ROUND and largest >= 0.1 * FITS):
        allowed = [each for each in allowed if each[0] >= 1]
    factor, prefix = next((each for each in allowed if largest >= FITS * each[0]), allowed[-1])
    return Scale(factor, prefix + unit)


def shown(value: float, unit: str = "", digits: int = 3) -> str:
    """Return a number with its unit as text, such as ``2.92 mm``; in words where there is none.

    It is given in the SI unit, empty or 1 for a number, and gets so many digits at most.
    """
    if math.isnan(value):
        return "unknown"
    if math.isinf(value):
        return "without end" if value > 0 else "−∞"
    scale = scale_for([value], unit)
    text = written(value / scale.factor, digits)
    return f"{text} {scale.unit}" if scale.unit else text


def written(value: float, digits: int = 3) -> str:
    """Return a number with some digits, without an exponent where it is of ordinary size."""
    if not math.isfinite(value):
        return "unknown" if math.isnan(value) else "∞" if value > 0 else "−∞"
    if value == 0:
        return "0"
    rounded = float(f"{value:.{digits}g}")
    if 1e-4 <= abs(rounded) < 1e6:
        places = max(digits - 1 - math.floor(math.log10(abs(rounded))), 0)
        text = f"{rounded:.{places}f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        mantissa, power = f"{rounded:.{digits - 1}e}".split("e")
        text = f"{mantissa.rstrip('0').rstrip('.')} · 10^{int(power)}"
    return text.replace("-", "−")


def percent(share: float, digits: int = 2) -> str:
    """Return a share in per cent."""
    return f"{written(100 * share, digits)} %"


WORDS = {
    **{"m": "displacement", "m/s": "velocity", "m/s²": "acceleration", "N": "force"},
    **{"rad": "angle", "rad/s": "angular velocity", "rad/s²": "angular acceleration", "N m": "moment"},
}
"""What is measured in a unit."""


def quantity_words(unit: str) -> str:
    """Return what an output is that has a unit."""
    return WORDS.get(unit, "output")


KEYS = {
    "inertia": "moment of inertia",
    "mass": "mass",
    "stiffness": "stiffness",
    "damping": "damping",
    "gap": "gap",
    "force": "kinetic friction",
    "static": "static friction",
    "viscous": "viscous friction",
    "amplitude": "amplitude",
    "velocity": "velocity",
    "constant": "constant force",
    "unbalance": "unbalance",
    "phase": "phase",
    "offset": "offset",
    "order": "order",
    **{"kp": "gain kp", "ki": "integral gain ki", "kd": "rate gain kd", "kv": "speed gain kv"},
    **{"ti": "integral time", "filter_time": "filter time", "tracking": "tracking time", "sample": "sample"},
    **{"limit": "limit", "delay": "delay", "feedforward": "feedforward"},
}


def place_words(place: str) -> str:
    """Return what a dotted place is, in words, such as ``gap of bridge``."""
    names = parse_place(place)
    if names == ("frequency",):
        return "frequency of the drive"
    if names[0] == "start":
        return f"{names[2]} of {names[1]} at the start"
    if names[0] in ("outputs", "points"):
        return f"weight of {names[-1]} in {names[1]}"
    return f"{KEYS.get(names[2], names[2])} of {names[1]}"
