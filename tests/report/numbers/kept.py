"""Numbers that the report solves, summed up: what claims judge and figures draw, and how much of it.

``python -m tests.report.numbers.kept`` writes the file anew; its diff is read.
"""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from numbers import Real
from pathlib import Path
from typing import Any

import control
import numpy as np

from report.numbers.evidence import Evidence, gather
from trimmer import response_at

KEPT = Path(__file__).with_name("kept.txt")
SUMMED = ("amplitude", "frequency", "stable", "duration", "force_per_gap")
"""What is told of an orbit, a limit cycle or a motion."""
LEFT_OUT = {
    *("advice", "kept", "branches", "branches_again", "over_force", "over_gap"),
    *("repeat", "mirror", "miss", "distance", "residual", "apart", "mirror_miss", "mirror_apart"),
    "left_above",
}
"""Fields that hold what is read from a file, and what rounding leaves."""
CHAOTIC = "twin.experiment.twin"  # A motion in which rounding grows
OMEGAS = (100.0, 1000.0, 5000.0)  # Where the response of a system is told, rad/s
NOTHING = 1e-9  # Share of the largest below which a number of an array is rounding


def told(thing: Any, name: str) -> Iterator[str]:
    """Yield a line for each number, and for each array its shape, its ends and its mean square's root."""
    if name.rpartition(".")[2] in LEFT_OUT or name == CHAOTIC:
        return
    if is_dataclass(thing) and type(thing).__module__.startswith("report."):
        for field in fields(thing):
            yield from told(getattr(thing, field.name), f"{name}.{field.name}")
    elif isinstance(thing, np.ndarray) and thing.dtype.kind in "biufc":
        yield f"{name} {thing.shape}: {_ends(thing)}"
    elif isinstance(thing, control.TransferFunction | control.StateSpace):
        yield f"{name}: {' '.join(_digits(complex(response_at(thing, omega))) for omega in OMEGAS)}"
    elif isinstance(thing, bool | int | float | complex | np.number | str):
        yield f"{name}: {_digits(thing)}"
    elif isinstance(thing, tuple | list) and all(isinstance(each, Real) for each in thing):
        yield f"{name}: {' '.join(map(_digits, thing))}"
    elif isinstance(thing, Mapping | tuple | list):
        inner = thing.items() if isinstance(thing, Mapping) else enumerate(thing)
        for key, each in inner:
            yield from told(each, f"{name}[{key}]")
    else:
        yield from (
            f"{name}.{each}: {_digits(getattr(thing, each))}" for each in SUMMED if hasattr(thing, each)
        )


def _ends(values: np.ndarray) -> str:
    sizes = np.abs(values) if values.dtype.kind == "c" else values.astype(float)
    finite = sizes[np.isfinite(sizes)]
    if not finite.size:
        return "nothing"
    ends = np.array([finite.min(), finite.max(), np.sqrt(np.mean(finite**2))])
    ends[np.abs(ends) < NOTHING * np.abs(ends).max()] = 0.0
    return " ".join(map(_digits, ends.tolist()))


def _digits(value: Any) -> str:
    if isinstance(value, complex):
        return f"{_digits(value.real)} {_digits(value.imag)}"
    return f"{float(value):.7g}" if isinstance(value, float | np.floating | Fraction) else str(value)


def summed_up(known: Evidence) -> str:
    """Return the lines for all numbers."""
    parts = {name: getattr(known, name) for name in ("numbers", "cycles", "motion", "twin")}
    return "".join(f"{line}\n" for name, part in parts.items() for line in told(part, name))


if __name__ == "__main__":
    KEPT.write_text(summed_up(gather()), "utf-8")
