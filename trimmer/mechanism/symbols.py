"""Symbols that parts carry for printed equations, such as ``k_2``."""

from __future__ import annotations

import re

SYMBOL_RULE = 'a symbol is a letter or a name, perhaps with an index, as in "k_2" or "k_bridge"'

_SYMBOL = re.compile(r"[^\W\d_]+[0-9]*(?:_[^\W_]+|_\{[^\W_]+(?:,[^\W_]+)*\})?")


def is_symbol(value: object) -> bool:
    """Say whether a value can be a symbol in printed equations."""
    return isinstance(value, str) and _SYMBOL.fullmatch(value) is not None
