"""The thirteen parameters of the linear trimmer: values, meanings, and the TOML files that hold them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import Field, dataclass, field, fields
from pathlib import Path
from typing import Any, Self

from trimmer.arguments import file_path, require_instance
from trimmer.errors import TrimmerError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import in_lines, near_match, shown_value
from trimmer.parameter_kinds import Parameter, ParameterKind, reason_against
from trimmer.showing.shown import counted
from trimmer.toml_files import is_mechanism_file, parsed, read_text

SCATTER = "uncertainty"  # The table of a parameter file that only ``trimmer sample`` reads
_TEMPLATE_HEAD = """\
# Parameters of a hair trimmer, in SI units.
# Every key is needed. Masses are positive; stiffness and damping are zero or positive.
"""


class ParameterError(TrimmerError, ValueError):
    """One or more parameters are unusable; the message names each with its value and the reason."""


def _of(quantity: ParameterKind, meaning: str) -> Any:
    return field(metadata={"meaning": meaning, "quantity": quantity})


@dataclass(frozen=True, kw_only=True)
class TrimmerParameters:
    """Parameters of the linear trimmer (figure 2.1b of the thesis), in SI units.

    Meaning and unit of each field are its metadata; ``parameter_table`` lists them. Masses are positive,
    stiffness and damping are not negative, all are finite. Integers become floats.

    Raises:
        ParameterError: if values are not finite real numbers or have the wrong sign; each is named.
    """

    m1: float = _of(ParameterKind.MASS, "mass of the motor")
    m2: float = _of(ParameterKind.MASS, "mass of the cutter with the driving bridge")
    m3: float = _of(ParameterKind.MASS, "mass of the guard housing")
    m4: float = _of(ParameterKind.MASS, "mass of the guard")
    k1: float = _of(ParameterKind.STIFFNESS, "stiffness of the motor mount")
    k2: float = _of(ParameterKind.STIFFNESS, "stiffness of the driving bridge")
    k3: float = _of(ParameterKind.STIFFNESS, "stiffness of the housing mount")
    k4: float = _of(ParameterKind.STIFFNESS, "stiffness between guard and housing")
    k5: float = _of(ParameterKind.STIFFNESS, "stiffness of the coil spring between cutter and housing")
    c1: float = _of(ParameterKind.DAMPING, "damping of the motor mount")
    c2: float = _of(ParameterKind.DAMPING, "damping of the driving bridge")
    c3: float = _of(ParameterKind.DAMPING, "damping of the housing mount")
    c4: float = _of(ParameterKind.DAMPING, "damping between guard and housing")

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
        return read_parameters(file_path("path", path))

    def to_toml(self) -> str:
        """Return the parameters as TOML text, each with its meaning and unit; it reads back equal."""
        lines, kind = [_TEMPLATE_HEAD], ParameterKind.MASS
        for parameter in parameter_table():
            if parameter.quantity is not kind:
                lines.append("\n")
            kind = parameter.quantity
            assignment = f"{parameter.symbol} = {getattr(self, parameter.symbol)!r}"
            lines.append(f"{assignment:<20} # {parameter.unit}, {parameter.meaning}\n")
        return "".join(lines)

    def to_mechanism(self, amplitude: float, frequency: float) -> Mechanism:
        """Return the trimmer (figure 2.1b) as a mechanism whose bridge is a link to the pin on the motor.

        Its parts carry the symbols of the thesis, and its output is the stroke, y = q2 - q4.

        Args:
            amplitude: Amplitude of the pin relative to the motor, m.
            frequency: Frequency of the drive, Hz.

        Raises:
            MechanismError: if amplitude or frequency is no such number.
        """
        from trimmer.mechanism.mechanism import Mechanism
        from trimmer.mechanism.parts import GROUND, Body, Link, Output, Pin

        return Mechanism(
            title="Linear trimmer",
            frequency=frequency,
            bodies={
                "motor": Body(self.m1, "m_1"),
                "cutter": Body(self.m2, "m_2"),
                "housing": Body(self.m3, "m_3"),
                "guard": Body(self.m4, "m_4"),
            },
            pins={"pin": Pin("motor", amplitude, symbol="u")},
            links={
                "motor mount": Link((GROUND, "motor"), self.k1, self.c1, "k_1"),
                "bridge": Link(("pin", "cutter"), self.k2, self.c2, "k_2"),
                "housing mount": Link((GROUND, "housing"), self.k3, self.c3, "k_3"),
                "guard spring": Link(("housing", "guard"), self.k4, self.c4, "k_4"),
                "coil spring": Link(("housing", "cutter"), self.k5, symbol="k_5"),
            },
            outputs={"stroke": Output({"cutter": 1.0, "guard": -1.0})},
        )

    def values(self) -> tuple[float, ...]:
        """Return the thirteen values, SI units, as the generated functions take them: m1-m4, k1-k5, c1-c4."""
        return tuple(getattr(self, parameter.symbol) for parameter in parameter_table())


def require_parameters(parameters: object) -> None:
    """Check that the parameters of a trimmer were given."""
    wanted = "the trimmer.TrimmerParameters of a trimmer, such as TrimmerParameters.thesis()"
    require_instance("parameters", parameters, TrimmerParameters, wanted)


def parameter_table() -> tuple[Parameter, ...]:
    """Return the description of every parameter, in the order m1-m4, k1-k5, c1-c4."""
    return tuple(_described(entry) for entry in fields(TrimmerParameters))


def _described(entry: Field[Any]) -> Parameter:
    return Parameter(entry.name, entry.metadata["meaning"], entry.metadata["quantity"])


def read_parameters(path: Path) -> TrimmerParameters:
    """Read parameters as ``TrimmerParameters.from_toml`` does, from a path or from ``-``."""
    content = _parsed(path)
    problems = [*_unknown_keys(content), *_missing_keys(content), *_unusable_values(content)]
    if problems:
        raise ParameterError(
            f"{path}: {counted(len(problems), 'problem')} in the parameters:{in_lines(problems)}"
        )
    return TrimmerParameters(**{key: value for key, value in content.items() if key != SCATTER})


def _parsed(path: Path) -> dict[str, Any]:
    text = read_text(path, ParameterError, "'trimmer parameters --output FILE' writes one to start from")
    content = parsed(text, str(path), ParameterError, "write one 'key = number' per line, as in 'm1 = 0.035'")
    if is_mechanism_file(content):
        raise ParameterError(
            f"{path}: this is a mechanism, for 'trimmer respond FILE' and 'trimmer simulate FILE'; "
            "'trimmer parameters --output FILE' writes a parameter file to start from"
        )
    return content


def _unknown_keys(content: dict[str, Any]) -> Iterator[str]:
    known = [parameter.symbol for parameter in parameter_table()]
    for key, value in content.items():
        if key in known or (key == SCATTER and isinstance(value, dict)):
            continue
        if isinstance(value, dict):
            yield f"[{key}]: tables are not used; write the keys without a heading"
            continue
        advice = near_match(key, known) or f"known keys: {', '.join(known)}"
        yield f"{key} = {shown_value(value)}: unknown key; {advice}"


def _missing_keys(content: dict[str, Any]) -> Iterator[str]:
    for parameter in parameter_table():
        if parameter.symbol not in content:
            yield (
                f"{parameter.symbol}: missing; add '{parameter.symbol} = NUMBER' "
                f"({parameter.unit}, {parameter.meaning})"
            )


def _unusable_values(content: dict[str, Any]) -> Iterator[str]:
    for parameter in parameter_table():
        if parameter.symbol not in content:
            continue
        value = content[parameter.symbol]
        reason = reason_against(value, parameter.quantity)
        if not reason:
            continue
        if isinstance(value, str):
            reason += ", without quotation marks; text is not evaluated"
        yield f"{parameter.symbol} = {shown_value(value)}: {reason}"
