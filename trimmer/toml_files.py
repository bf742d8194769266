"""TOML files that users write: their text, and which kind of file one is."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from trimmer.errors import TrimmerError
from trimmer.files import read_content
from trimmer.messages import near_file

PARAMETER = re.compile("m[1-4]|k[1-5]|c[1-4]")
"""Symbols of the parameters of the thesis's trimmer, which are the keys of its files."""


def read_text(path: Path, error: type[TrimmerError], advice: str) -> str:
    """Read the text of a file, or of standard input; see ``read_bytes_of_text``."""
    return decoded(read_bytes_of_text(path, error, advice))


def decoded(content: bytes) -> str:
    """Return the text of a file; some editors begin one with a byte order mark."""
    return content.decode("utf-8-sig")


def read_bytes_of_text(path: Path, error: type[TrimmerError], advice: str) -> bytes:
    """Read a file of text, or standard input for ``-``, as it is; the error and its advice are given."""
    try:
        content = read_content(path)
        text = decoded(content)
    except FileNotFoundError:
        raise error(f"{path}: no such file; {near_file(path) or advice}") from None
    except IsADirectoryError:
        raise error(f"{path}: is a folder; name the file in it") from None
    except UnicodeDecodeError as reason:
        message = f"{path}: not UTF-8 text (byte {reason.start}); save it as UTF-8 plain text"
        raise error(message) from reason
    except OSError as reason:
        raise error(f"{path}: cannot be read: {reason.strerror or reason}; {advice}") from reason
    if not text.strip():
        raise error(f"{path}: is empty; {advice}")
    return content


def parsed(text: str, name: str, error: type[TrimmerError], advice: str) -> dict[str, Any]:
    """Return the content of a file from its text, which messages call by a name; the error is given."""
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as reason:  # ValueError: syntax, or an integer of too many digits
        raise error(f"{name}: not valid TOML: {reason}; {advice}") from reason


def is_parameter_file(content: Mapping[str, object]) -> bool:
    """Say whether the content of a file holds parameters of the thesis's trimmer, and no bodies."""
    return "bodies" not in content and any(map(PARAMETER.fullmatch, content))


def is_mechanism_file(content: Mapping[str, object]) -> bool:
    """Say whether the content of a file is a mechanism."""
    return isinstance(content.get("bodies"), dict)
