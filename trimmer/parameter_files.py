"""Trimmer parameters as TOML files: reading with complete error messages, and the commented template."""

from __future__ import annotations

import difflib
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from trimmer.files import read_content
from trimmer.parameters import ParameterError, TrimmerParameters, parameter_table, reason_against

_TEMPLATE_HEAD = """\
# Parameters of a hair trimmer, in SI units.
# Every key is needed. Masses are positive; stiffness and damping are zero or positive.
"""

_SHOWN_VALUE_LENGTH = 40


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
        listed = "".join(f"\n  {problem}" for problem in problems)
        raise ParameterError(f"{path}: {_count(len(problems))} in the parameters:{listed}")
    return TrimmerParameters(**content)


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
    try:
        text = read_content(path).decode("utf-8-sig")  # some editors begin a file with a byte order mark
    except FileNotFoundError:
        raise ParameterError(
            f"{path}: no such file; 'trimmer parameters --output FILE' writes one to start from"
        ) from None
    except IsADirectoryError:
        raise ParameterError(f"{path}: is a folder; name the parameter file in it") from None
    except UnicodeDecodeError as error:
        raise ParameterError(
            f"{path}: not UTF-8 text (byte {error.start}); save it as UTF-8 plain text"
        ) from error
    except OSError as error:
        raise ParameterError(f"{path}: cannot be read: {error.strerror or error}") from error
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # ValueError: TOML syntax, or an integer of too many digits
        raise ParameterError(
            f"{path}: not valid TOML: {error}; write one 'key = number' per line, as in 'm1 = 0.035'"
        ) from error


def _unknown_keys(content: dict[str, Any]) -> Iterator[str]:
    known = [parameter.symbol for parameter in parameter_table()]
    for key, value in content.items():
        if key in known:
            continue
        if isinstance(value, dict):
            yield f"[{key}]: tables are not used; write the keys without a heading"
            continue
        nearest = difflib.get_close_matches(key.lower(), known, n=1, cutoff=0.4)
        advice = f"did you mean {nearest[0]}?" if nearest else f"known keys: {', '.join(known)}"
        yield f"{key} = {_shown(value)}: unknown key; {advice}"


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
        yield f"{parameter.symbol} = {_shown(value)}: {reason}"


def _shown(value: object) -> str:
    """Give a value as text that stays short; an integer may have more digits than Python will print."""
    try:
        text = repr(value)
    except ValueError:
        return "an integer of thousands of digits"
    return text if len(text) <= _SHOWN_VALUE_LENGTH else f"{text[: _SHOWN_VALUE_LENGTH - 3]}..."


def _count(problems: int) -> str:
    return "1 problem" if problems == 1 else f"{problems} problems"
