"""The thirteen parameters of the linear trimmer: values, meanings, units and validation."""

from __future__ import annotations

import math
from dataclasses import Field, dataclass, field, fields
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from trimmer.arguments import file_path, require_instance
from trimmer.errors import TrimmerError
from trimmer.sizes import reason_against_size

if TYPE_CHECKING:
    from trimmer.mechanism.mechanism import Mechanism


class ParameterError(TrimmerError, ValueError):
    """One or more parameters are unusable; the message names each with its value and the reason."""


class ParameterKind(Enum):
    """What a parameter measures; the value is its SI unit."""

    MASS = "kg"
    STIFFNESS = "N/m"
    DAMPING = "N s/m"

    @property
    def unit(self) -> str:
        """SI unit as plain text, such as ``N/m``."""
        return self.value


@dataclass(frozen=True)
class Parameter:
    """Description of one parameter.

    Attributes:
        symbol: Name of the field of ``TrimmerParameters``, such as ``m1``.
        meaning: What it is, in words.
        quantity: What it measures, which determines its unit and its sign.
    """

    symbol: str
    meaning: str
    quantity: ParameterKind

    @property
    def unit(self) -> str:
        """SI unit of the parameter as plain text, such as ``N/m``."""
        return self.quantity.unit


def _mass(meaning: str) -> Any:
    return field(metadata={"meaning": meaning, "quantity": ParameterKind.MASS})


def _stiffness(meaning: str) -> Any:
    return field(metadata={"meaning": meaning, "quantity": ParameterKind.STIFFNESS})


def _damping(meaning: str) -> Any:
    return field(metadata={"meaning": meaning, "quantity": ParameterKind.DAMPING})


@dataclass(frozen=True, kw_only=True)
class TrimmerParameters:
    """Parameters of the linear trimmer (figure 2.1b of the thesis), in SI units.

    Meaning and unit of each field are its metadata; ``parameter_table`` lists them. Masses are positive,
    stiffness and damping are not negative, all are finite. Integers become floats.

    Raises:
        ParameterError: if values are not finite real numbers or have the wrong sign; each is named.
    """

    m1: float = _mass("mass of the motor")
    m2: float = _mass("mass of the cutter with the driving bridge")
    m3: float = _mass("mass of the guard housing")
    m4: float = _mass("mass of the guard")
    k1: float = _stiffness("stiffness of the motor mount")
    k2: float = _stiffness("stiffness of the driving bridge")
    k3: float = _stiffness("stiffness of the housing mount")
    k4: float = _stiffness("stiffness between guard and housing")
    k5: float = _stiffness("stiffness of the coil spring between cutter and housing")
    c1: float = _damping("damping of the motor mount")
    c2: float = _damping("damping of the driving bridge")
    c3: float = _damping("damping of the housing mount")
    c4: float = _damping("damping between guard and housing")

    def __post_init__(self) -> None:
        problems = [
            f"{parameter.symbol} = {getattr(self, parameter.symbol)!r}: {reason}"
            for parameter in parameter_table()
            if (reason := reason_against(getattr(self, parameter.symbol), parameter.quantity))
        ]
        if problems:
            raise ParameterError("; ".join(problems))
        for parameter in parameter_table():
            object.__setattr__(self, parameter.symbol, float(getattr(self, parameter.symbol)))

    @classmethod
    def thesis(cls) -> Self:
        """Return the parameters of the thesis's trimmer (Listing A.1)."""
        return cls(
            **{"m1": 0.035, "m2": 0.003, "m3": 0.005, "m4": 0.030},
            **{"k1": 200e3, "k2": 30e3, "k3": 150e3, "k4": 100e3, "k5": 1e3},
            **{"c1": 3.5, "c2": 0.4, "c3": 1.0, "c4": 4.0},
        )

    @classmethod
    def from_toml(cls, path: Path | str) -> TrimmerParameters:
        """Read parameters from a TOML file with one key per parameter; ``to_toml`` gives such a file.

        The path ``-`` is standard input.

        Raises:
            ParameterError: if the file cannot be read or is not TOML, or for unknown keys, missing keys and
                unusable values. Every problem is named, with the file, the key, the value and the reason.
        """
        from trimmer.parameter_files import read_parameters

        return read_parameters(file_path("path", path))

    def to_toml(self) -> str:
        """Return the parameters as TOML text, each with its meaning and unit; it reads back equal."""
        from trimmer.parameter_files import parameters_as_toml

        return parameters_as_toml(self)

    def to_mechanism(self, amplitude: float, frequency: float) -> Mechanism:
        """Return the trimmer as a mechanism whose bridge is a link to the pin on the motor.

        Its parts carry the symbols of the thesis, and its output is the stroke, y = q2 - q4.

        Args:
            amplitude: Amplitude of the pin relative to the motor, m.
            frequency: Frequency of the drive, Hz.

        Raises:
            MechanismError: if amplitude or frequency is no such number.
        """
        from trimmer.mechanism.thesis import linear_mechanism

        return linear_mechanism(self, amplitude, frequency)

    def values(self) -> tuple[float, ...]:
        """Return the thirteen values, SI units, as the generated functions take them: m1-m4, k1-k5, c1-c4."""
        return tuple(getattr(self, parameter.symbol) for parameter in parameter_table())


def require_parameters(parameters: object) -> None:
    """Check that the parameters of a trimmer were given.

    Raises:
        WrongTypeError: if they were not.
    """
    wanted = "the trimmer.TrimmerParameters of a trimmer, such as TrimmerParameters.thesis()"
    require_instance("parameters", parameters, TrimmerParameters, wanted)


def parameter_table() -> tuple[Parameter, ...]:
    """Return the description of every parameter, in the order m1-m4, k1-k5, c1-c4."""
    return tuple(_described(entry) for entry in fields(TrimmerParameters))


def _described(entry: Field[Any]) -> Parameter:
    return Parameter(entry.name, entry.metadata["meaning"], entry.metadata["quantity"])


def reason_against(value: object, quantity: ParameterKind) -> str:
    """Return why a value cannot be used as such a quantity, as a piece of a message; empty if it can.

    NumPy's real scalars count as numbers; truth values, text and complex numbers do not.
    """
    if isinstance(value, bool) or not hasattr(value, "__float__") or isinstance(value, complex):
        return f"give a number in {quantity.unit}"
    try:
        number = float(value)
    except OverflowError:
        return "too large for a floating-point number"
    except (TypeError, ValueError):
        return f"give a number in {quantity.unit}"
    if not math.isfinite(number):
        return "must be finite"
    if reason := reason_against_size(number):
        return reason
    if quantity is ParameterKind.MASS and number <= 0:
        return "a mass must be greater than zero"
    if number < 0:
        return f"{quantity.name.lower()} must not be negative"
    return ""
