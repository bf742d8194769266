"""What was read: the thesis as far as its text copy has it, and that copy."""

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, final

from report.pages.provenance import BuildTime

PATH = Path(__file__).parent / "thesis.toml"


@final
@dataclass(frozen=True)
class TextCopy:
    """What is known of the thesis and of the text that was read."""

    sha256: str  # Of the bytes of the text
    lines: int  # How many it has
    title: str = ""  # Of the thesis, as the text has it
    kind: str = ""  # What the thesis calls itself
    institution: str = ""  # Where it was made, as far as the text says
    lacks: tuple[str, ...] = ()  # What a reader would look for and the text does not have


def read_text_copy() -> TextCopy:
    """Read what is known of the text that was read."""
    content = _content()
    del content["build"]
    return TextCopy(**content | {"lacks": tuple(content["lacks"])})


def read_build_time() -> BuildTime:
    """Read what processor time the report took from nothing."""
    return BuildTime(**_content()["build"])


def _content() -> dict[str, Any]:
    with PATH.open("rb") as file:
        return tomllib.load(file)
