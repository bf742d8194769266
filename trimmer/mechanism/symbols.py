"""Symbols that parts carry for printed equations, such as ``k_2``."""

from __future__ import annotations

import re

SYMBOL_RULE = 'a symbol is a letter or a name, perhaps with an index, as in "k_2" or "k_bridge"'

_LETTER = "A-Za-zΑ-Ωα-ω"
_SYMBOL = re.compile(rf"[{_LETTER}]+[0-9]*(?:_[{_LETTER}0-9]+|_\{{[{_LETTER}0-9]+(?:,[{_LETTER}0-9]+)*\}})?")


def is_symbol(value: object) -> bool:
    """Say whether a value can be a symbol in printed equations."""
    return isinstance(value, str) and _SYMBOL.fullmatch(value) is not None
