"""Says whether two texts of a command are alike: word for word, and number for number to rounding."""

import json
import re
from collections.abc import Iterator
from typing import Any

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?", re.IGNORECASE)
ROUNDING = 1e-7
"""Relative difference of two numbers that a processor's rounding can make, amplified by what is solved."""
NOTHING = 1e-10  # What is below stands for zero: residuals, phases and multipliers that are rounding
OF_LIST = 1e-12  # Share of the largest number of a list by which rounding moves its others, as in harmonics
LONG = 5  # Digits from which the last one may be rounded either way
MOST = 8  # Entries of a list that are shown


def alike(kept: str, found: str) -> bool:
    """Say whether two texts differ by no more than digits that rounding can reach.

    Where digits differ, blanks may too: the columns of a table are as wide as their numbers.
    """
    if kept == found:
        return True
    first, second = NUMBER.findall(kept), NUMBER.findall(found)
    if first == second or len(first) != len(second):
        return False
    words = ([piece.split() for piece in NUMBER.split(each)] for each in (kept, found))
    return next(words) == next(words) and all(map(_close, first, second, _of_lists(kept)))


def _of_lists(text: str) -> Iterator[float]:
    """Yield for each number the largest one of its list; 0 for one that is not in a list."""
    for line in text.splitlines():
        sizes = [abs(float(each)) for each in NUMBER.findall(line)]
        yield from [
            max(sizes, default=0.0) if line.lstrip().partition(": ")[2].startswith("[") else 0.0
        ] * len(sizes)


def _close(kept: str, found: str, largest: float) -> bool:
    one, other = float(kept), float(found)
    if max(abs(one), abs(other)) < NOTHING or abs(one - other) <= OF_LIST * largest:
        return True
    digits = max(_digits(kept), _digits(found))
    step = min(_step(kept), _step(found)) if digits >= LONG else 0.0
    return abs(one - other) <= max(1.01 * step, ROUNDING * max(abs(one), abs(other)))


def _digits(text: str) -> int:
    return len(re.sub(r"e.*|\D", "", text.lower()).lstrip("0"))


def _step(text: str) -> float:
    """Return what the last digit of a number counts."""
    mantissa, _, power = text.lower().partition("e")
    return float(10.0 ** (int(power or 0) - len(mantissa.partition(".")[2])))


def readable(text: str) -> str:
    """Return what a command prints in a form that is read in a diff.

    JSON gets one key in a line, twelve digits, and the first entries of long lists; options of a help stand
    in one line each, whatever the version of Python; speeds are left out; no line ends with a blank.
    """
    if text.startswith("{"):
        text = "\n".join(_lines(json.loads(text)))
    elif text.startswith("usage: "):
        text = _unwrapped(text)
    text = re.sub(r"\S+ samples per second", "... samples per second", text)
    return "\n".join(line.rstrip() for line in text.splitlines()).strip("\n")


def _lines(value: Any, key: str = "", indent: str = "") -> list[str]:
    if isinstance(value, dict) and value:
        inner = [line for name, each in value.items() for line in _lines(each, f"{name}: ", f"{indent}  ")]
        return [f"{indent}{key}{{", *inner, f"{indent}}}"]
    if isinstance(value, list) and any(isinstance(each, dict) for each in value):
        inner = [line for each in value[:MOST] for line in _lines(each, "", f"{indent}  ")]
        return [f"{indent}{key}[", *inner, f"{indent}]{_more(value)}"]
    return [f"{indent}{key}{_short(value)}"]


def _short(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_short, value[:MOST]))}]{_more(value)}"
    return f"{value:.12g}" if isinstance(value, float) else json.dumps(value, ensure_ascii=False)


def _more(entries: list[Any]) -> str:
    return f" and {len(entries) - MOST} more" if len(entries) > MOST else ""


def _unwrapped(text: str) -> str:
    """Return a help without its usage, each option in a line, and one name of it with what it takes."""
    told = text.partition("\n\n")[2]
    told = re.sub(r"\n {11,}(?=\S)", "  ", told)
    told = re.sub(r"(--[\w-]+) \S+, (?=--)", r"\1, ", told)
    return re.sub(r"(?<=\S) {2,}", "  ", told)
