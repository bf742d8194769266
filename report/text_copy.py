"""The text that was read: a copy of the thesis that a machine read from its pages."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import final

PATH = Path(__file__).parent / "data" / "thesis.toml"


@final
@dataclass(frozen=True)
class TextCopy:
    """What is known of the text that was read: the SHA-256 of its bytes, and its number of lines."""

    sha256: str
    lines: int


def read_text_copy() -> TextCopy:
    """Read what is known of the text that was read."""
    with PATH.open("rb") as file:
        return TextCopy(**tomllib.load(file))
