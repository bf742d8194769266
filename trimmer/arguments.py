"""Checks of what is given to a function or a class: each names the argument and the value."""

from __future__ import annotations

import inspect
import math
import operator
import os
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trimmer.errors import WrongTypeError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Reals

_LONGEST = 200
LARGEST_COUNT = 2**62
"""Largest whole number; beyond it, no number of things fits into an integer of the computer."""
MOST_EVENTS = 4_000_000  # Events of a simulation if no number is given: about a GB with a dozen states


def shown(value: object) -> str:
    """Show a value in a message: shortened where it is long, and a class as a class."""
    if inspect.isclass(value):
        return f"the class {value.__name__}; give an instance of it"
    text = repr(value)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]} ..."


def require_instance(name: str, value: object, kinds: type[Any] | tuple[type[Any], ...], wanted: str) -> None:
    """Check that an argument is an instance of a class, or of one of several; messages say what is wanted."""
    if not isinstance(value, kinds):
        raise WrongTypeError(f"{name} must be {wanted}, not {shown(value)}")


def require_instances(name: str, values: object, kinds: type[Any], wanted: str) -> tuple[Any, ...]:
    """Check that an argument is a sequence of instances of a class, and return them."""
    if isinstance(values, str | bytes) or not hasattr(type(values), "__iter__"):
        raise WrongTypeError(f"{name} must be a sequence, each entry {wanted}, not {shown(values)}")
    entries: tuple[Any, ...] = tuple(values)  # type: ignore[arg-type]
    for place, entry in enumerate(entries):
        require_instance(f"{name}[{place}]", entry, kinds, wanted)
    return entries


def scalar(value: object) -> object:
    """Return the number or truth value of an array of NumPy without dimensions; all else as it is."""
    return value.item() if getattr(value, "shape", None) == () and hasattr(value, "item") else value


def real_number(name: str, value: object, unit: str = "") -> float:
    """Return a real number as a float; infinity and NaN pass.

    Truth values, text, complex numbers and arrays are none.
    """
    of_unit = f" ({unit})" if unit else ""
    number = scalar(value)
    if not isinstance(number, bool) and isinstance(number, Real):
        try:
            return float(number)
        except OverflowError:
            return math.inf
    raise WrongTypeError(f"{name} must be a real number{of_unit}, not {shown(value)}")


def finite_number(name: str, value: object, unit: str = "") -> float:
    """Return a finite real number as a float."""
    number = real_number(name, value, unit)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, not {value!r}")
    return number


def positive_number(name: str, value: object, unit: str = "") -> float:
    """Return a positive, finite real number as a float."""
    number = real_number(name, value, unit)
    if not 0 < number < math.inf:
        raise ValueError(f"{name} must be positive and finite{f' ({unit})' if unit else ''}, not {value!r}")
    return number


def whole_number(name: str, value: object, least: int | None = None) -> int:
    """Return a whole number from the least one on, if there is one, as an int."""
    wanted = "a whole number" if least is None else f"a whole number from {least} on"
    try:
        number = None if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        number = None
    if number is None:
        raise WrongTypeError(f"{name} must be {wanted}, not {shown(value)}")
    if number > LARGEST_COUNT:
        raise ValueError(f"{name} must be at most {LARGEST_COUNT}, not {shown(value)}")
    if least is not None and number < least:
        raise ValueError(f"{name} must be {wanted}, not {value!r}")
    return number


def truth_value(name: str, value: object) -> bool:
    """Return True or False, as a bool."""
    given = scalar(value)
    require_instance(name, given, bool, "True or False")
    return bool(given)


def file_path(name: str, path: object) -> Path:
    """Return the path of a file."""
    require_instance(name, path, (str, os.PathLike), "the path of a file")
    return Path(path)  # type: ignore[arg-type]


def real_array(name: str, values: ArrayLike) -> Reals:
    """Return real, finite numbers as an array of floats."""
    import numpy as np

    array = real_values(name, values)
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, but holds {float(array[~np.isfinite(array)].flat[0])!r}")
    return array


def real_values(name: str, values: ArrayLike) -> Reals:
    """Return real numbers as an array of floats; infinity and NaN pass."""
    import numpy as np

    try:
        array = np.asarray(values)
    except (TypeError, ValueError):  # nested lists of unequal length
        array = np.asarray(None)
    if array.dtype.kind not in "fiu" and array.size:
        raise WrongTypeError(f"{name} must be a real number or an array of such, not {shown(values)}")
    return array.astype(float, copy=False)
