"""Trimmer parameters as TOML files: reading with complete error messages, and the commented template."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from trimmer.messages import in_lines, near_match, shown_value
from trimmer.parameters import ParameterError, TrimmerParameters, parameter_table, reason_against
from trimmer.toml_files import is_mechanism_file, parsed, read_text

SCATTER = "uncertainty"
"""The table of a parameter file that only ``trimmer sample`` reads."""
_TEMPLATE_HEAD = """\
# Parameters of a hair trimmer, in SI units.
# Every key is needed. Masses are positive; stiffness and damping are zero or positive.
"""


def read_parameters(path: Path) -> TrimmerParameters:
    """Read parameters from a TOML file with one key per parameter.

    Text in the file is never evaluated: a value is a TOML number or it is refused.

    Args:
        path: The file; values in SI units.

    Raises:
        ParameterError: if the file cannot be read or is not TOML, or for unknown keys, missing keys and
            unusable values; every problem is named, with the file, the key, the value and the reason.
    """
    content = _parsed(path)
    problems = [*_unknown_keys(content), *_missing_keys(content), *_unusable_values(content)]
    if problems:
        raise ParameterError(f"{path}: {_count(len(problems))} in the parameters:{in_lines(problems)}")
    return TrimmerParameters(**{key: value for key, value in content.items() if key != SCATTER})


def parameters_as_toml(parameters: TrimmerParameters) -> str:
    """Give parameters as TOML text, each with its meaning and unit as a comment; it reads back equal."""
    lines = [_TEMPLATE_HEAD]
    quantity = None
    for parameter in parameter_table():
        if quantity is not None and parameter.quantity is not quantity:
            lines.append("\n")
        quantity = parameter.quantity
        assignment = f"{parameter.symbol} = {getattr(parameters, parameter.symbol)!r}"
        lines.append(f"{assignment:<20} # {parameter.unit}, {parameter.meaning}\n")
    return "".join(lines)


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


def _count(problems: int) -> str:
    return "1 problem" if problems == 1 else f"{problems} problems"
