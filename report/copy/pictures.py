"""Whether a picture beside a text can be read as what its name says that it is."""

from __future__ import annotations

from pathlib import Path
from typing import Final
from xml.etree import ElementTree

PIXELS: Final = frozenset((".png", ".jpg", ".jpeg", ".gif", ".webp"))


def fault_of_picture(path: Path) -> str:
    """Return what is wrong with an SVG or a picture of pixels, or nothing; others are not looked into."""
    try:
        if path.suffix.lower() == ".svg":
            tag = ElementTree.parse(path).getroot().tag
            return "" if tag.rpartition("}")[2] == "svg" else f"its outermost element is {tag}, not svg"
        if path.suffix.lower() in PIXELS:
            from PIL import Image  # takes long; seldom needed

            with Image.open(path) as picture:
                picture.load()
    except (OSError, SyntaxError, ValueError) as error:  # ParseError and a broken PNG are SyntaxErrors
        return str(error)
    return ""
