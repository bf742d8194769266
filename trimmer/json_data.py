"""JSON that somebody else may have written or damaged: parsed without surprises, and read as typed data."""

import json
import math
import types
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

from trimmer.arguments import LARGEST_COUNT
from trimmer.choices import Choice
from trimmer.messages import shown_value

Data = TypeVar("Data")
_LONGEST_PLACE = 80


class DataError(ValueError):
    """Data that are not what they should be; the message says where and what, and no more."""


def parsed_json(content: bytes | str) -> Any:
    """Return what a JSON text in UTF-8 says, without NaN, infinity and keys twice, of sensible depth."""
    try:
        text = content if isinstance(content, str) else content.decode("utf-8")
        return json.loads(text, parse_constant=_refused, object_pairs_hook=_object)
    except UnicodeDecodeError as error:
        raise DataError(f"it is no JSON in UTF-8 (byte {error.start})") from error
    except RecursionError as error:
        raise DataError("it is nested too deeply") from error
    except json.JSONDecodeError as error:
        raise DataError(f"it is no JSON in UTF-8 ({error.msg} at character {error.pos + 1})") from error
    except DataError:
        raise
    except ValueError as error:  # a whole number of thousands of digits
        raise DataError("it holds a number of thousands of digits") from error


def _refused(word: str) -> float:
    raise DataError(f"{word} is no number of JSON")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        raise DataError(f"the key {shown_value(max(names, key=names.count))} is there twice")
    return found


def typed(kind: type[Data], data: Any) -> Data:
    """Return parsed JSON as a frozen class whose fields say what is to be there, all of it and no more.

    Fields may be whole numbers, finite numbers, text, truth values, choices by their words, None, classes
    of this kind, tuples, and dictionaries with text as keys. Errors name the place in the data.
    """
    found: Data = _typed(kind, data, "")
    return found


def _typed(kind: Any, data: Any, place: str) -> Any:
    origin = get_origin(kind)
    if origin in (Union, types.UnionType):
        return _one_of(get_args(kind), data, place)
    if origin is tuple:
        return _entries(get_args(kind), data, place)
    if origin in (dict, Mapping):
        return {
            name: _typed(get_args(kind)[1], each, f"{place}.{name}") for name, each in _table(data, place)
        }
    if is_dataclass(kind):
        return _instance(kind, data, place)
    if isinstance(kind, type) and issubclass(kind, Enum):
        return _choice(kind, data, place)
    return _plain(kind, data, place)


def _one_of(kinds: tuple[Any, ...], data: Any, place: str) -> Any:
    if data is None and types.NoneType in kinds:
        return None
    *others, last = (kind for kind in kinds if kind is not types.NoneType)
    for kind in others:
        try:
            return _typed(kind, data, place)
        except DataError:
            continue
    return _typed(last, data, place)


def _entries(kinds: tuple[Any, ...], data: Any, place: str) -> tuple[Any, ...]:
    if not isinstance(data, list):
        raise _wrong(place, data, "a list")
    if kinds[-1] is Ellipsis:
        kinds = (kinds[0],) * len(data)
    if len(kinds) != len(data):
        raise DataError(f"{_called(place)} has {len(data)} entries, not {len(kinds)}")
    pairs = zip(kinds, data, strict=True)
    return tuple(_typed(kind, each, f"{place}[{at}]") for at, (kind, each) in enumerate(pairs))


def _table(data: Any, place: str) -> Any:
    if not isinstance(data, dict):
        raise _wrong(place, data, "an object")
    return data.items()


def _instance(kind: Any, data: Any, place: str) -> Any:
    given = dict(_table(data, place))
    hints = get_type_hints(kind)
    for each in fields(kind):
        if each.name not in given:
            raise DataError(f"{_called(place)} has no {each.name}")
    for name in given:
        if name not in hints:
            raise DataError(f"{_called(place)} has an unknown key {shown_value(name)}")
    return kind(**{name: _typed(hints[name], each, f"{place}.{name}") for name, each in given.items()})


def _choice(kind: Any, data: Any, place: str) -> Any:
    words = {each.word: each for each in kind} if issubclass(kind, Choice) else {}
    if not isinstance(data, str) or data not in words:
        raise _wrong(place, data, f"one of {', '.join(words)}")
    return words[data]


def _plain(kind: Any, data: Any, place: str) -> Any:
    if kind is float:
        if isinstance(data, bool) or not isinstance(data, int | float):
            raise _wrong(place, data, "a number")
        try:
            number = float(data)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise _wrong(place, data, "a finite number")
        return number
    if kind is int:
        if isinstance(data, bool) or not isinstance(data, int) or abs(data) > LARGEST_COUNT:
            raise _wrong(place, data, "a whole number")
        return data
    if not isinstance(data, kind):
        raise _wrong(place, data, {str: "text", bool: "true or false"}[kind])
    return data


def _wrong(place: str, data: Any, wanted: str) -> DataError:
    shown = (
        "an object" if isinstance(data, dict) else "a list" if isinstance(data, list) else shown_value(data)
    )
    return DataError(f"{_called(place)} is {shown}, not {wanted}")


def _called(place: str) -> str:
    called = place.removeprefix(".") or "it"
    return called if len(called) <= _LONGEST_PLACE else f"{called[: _LONGEST_PLACE - 3]}..."
