"""Files as somebody else may leave them: valid ones, cut, mixed up, or with something strange in a place."""

import json
import re
from typing import Any

from hypothesis import strategies as st

NESTED = "[" * 3000 + "]" * 3000
STRANGE = (
    *("null", "true", "-1", "0", "1", "1e308", "-5e-324", "1e999", "9" * 30, "9" * 5000, "NaN", "-Infinity"),
    *("nan", "inf", '""', '"periodic"', '"\\u0000"', '"é"', "[]", "{}", "[[1.0]]", '{"a": 1}', "x", "", "#"),
    NESTED,
)
"""Words to put in place of a value: wrong types, numbers beyond all bounds, what only one language knows."""
_VALUE = re.compile(rb'"[^"\n]*"|-?\b\d[\w.+-]*|\btrue\b|\bnull\b')


@st.composite
def damaged(draw: st.DrawFn, content: bytes) -> bytes:
    """Return the content of a file after one damage or two."""
    for _ in range(draw(st.integers(1, 2))):
        content = draw(st.sampled_from([_cut, _strange_value, _lines, _bytes, _filled]))(draw, content)
    return content


def _cut(draw: st.DrawFn, content: bytes) -> bytes:
    return content[: draw(st.integers(0, len(content)))]


def _strange_value(draw: st.DrawFn, content: bytes) -> bytes:
    found = list(_VALUE.finditer(content))
    if not found:
        return content
    place = draw(st.sampled_from(found))
    return content[: place.start()] + draw(st.sampled_from(STRANGE)).encode() + content[place.end() :]


def _lines(draw: st.DrawFn, content: bytes) -> bytes:
    """Drop a line, or write it a second time."""
    lines = content.splitlines(keepends=True)
    if not lines:
        return content
    at = draw(st.integers(0, len(lines) - 1))
    return b"".join([*lines[:at], *([lines[at]] * draw(st.sampled_from([0, 2]))), *lines[at + 1 :]])


def _bytes(draw: st.DrawFn, content: bytes) -> bytes:
    at = draw(st.integers(0, len(content)))
    return content[:at] + draw(st.binary(min_size=1, max_size=8)) + content[at + draw(st.integers(0, 8)) :]


def _filled(draw: st.DrawFn, content: bytes) -> bytes:
    return draw(st.sampled_from([b"", b"\n", b"\x00" * 64, b"\xff\xfe" + content, NESTED.encode()]))


@st.composite
def damaged_data(draw: st.DrawFn, data: Any) -> str:
    """Return parsed JSON as text after a key is gone, is new, or holds something else."""
    places = list(_places(data))
    place = draw(st.sampled_from(places))
    marked = _changed(data, place, draw(st.sampled_from(["drop", "add", "replace"])))
    return json.dumps(marked, ensure_ascii=False).replace('"STRANGE"', draw(st.sampled_from(STRANGE)))


def _places(data: Any, place: tuple[Any, ...] = ()) -> Any:
    yield place
    entries = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for name, each in entries:
        yield from _places(each, (*place, name))


def _changed(data: Any, place: tuple[Any, ...], how: str) -> Any:
    if not place:
        return {**data, "another": "STRANGE"} if how == "add" and isinstance(data, dict) else "STRANGE"
    name, *others = place
    inner = _changed(data[name], tuple(others), how)
    if isinstance(data, dict):
        rest = {key: each for key, each in data.items() if key != name}
        return rest if how == "drop" and not others else {**rest, name: inner}
    return data[:name] + ([] if how == "drop" and not others else [inner]) + data[name + 1 :]
