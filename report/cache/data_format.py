"""Results as bytes that hold data alone: reading them makes data and never runs what somebody put there.

A file is a digest of all that follows, a line of JSON, and the bytes of its arrays. The JSON is a table: each
entry is a tag with what it holds, and names others by their row, which stands further up. What two results
share is there once. Made again are numbers, text, arrays, collections, SymPy's expressions, systems of
python-control, and the frozen dataclasses, named tuples and enumerations of this project, from their fields;
nothing else.
"""

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from enum import Enum
from fractions import Fraction
from functools import cache
from importlib import import_module
from typing import Any

from report.cache import foreign_data
from trimmer.mechanism.read_only import ReadOnly

PACKAGES = ("derivations", "trimmer", "report")
NUMERIC = "biufcUS"  # Kinds of arrays that hold numbers or text and no objects
COLLECTIONS: Mapping[str, type] = {each.__name__: each for each in (tuple, list, set, frozenset)}


class DamagedError(ValueError):
    """The bytes are not what was written."""


def to_bytes(value: object) -> bytes:
    """Return a result as bytes.

    Raises:
        TypeError: if a part of it is of a type that is not made again.
    """
    writer = _Writer()
    top = writer.reference(value)
    table = json.dumps([writer.table, top], separators=(",", ":")).encode()
    content = table + b"\n" + bytes(writer.raw)
    return hashlib.sha256(content).hexdigest().encode() + b"\n" + content


def from_bytes(content: bytes) -> Any:
    """Return the result.

    Raises:
        DamagedError: if the bytes are not what ``to_bytes`` has written.
    """
    digest, _, rest = content.partition(b"\n")
    if hashlib.sha256(rest).hexdigest().encode() != digest:
        raise DamagedError("the digest is another one")
    table, _, raw = rest.partition(b"\n")
    try:
        entries, top = json.loads(table)
        reader = _Reader(raw)
        for entry in entries:
            reader.made.append(reader.entry(*entry))
        return reader.value(top)
    # It was written by somebody else, who may have put anything there.
    except Exception as error:
        raise DamagedError(f"{type(error).__name__}: {error}") from error


@dataclass
class _Writer:
    table: list[list[Any]] = field(default_factory=list)
    raw: bytearray = field(default_factory=bytearray)
    _rows: dict[int, int] = field(default_factory=dict)
    _alive: list[object] = field(default_factory=list)

    def reference(self, value: Any) -> Any:
        """Return a plain value as it is, and the row of another one in a list."""
        if value is None or type(value) in (bool, int, float, str):
            return value
        if id(value) not in self._rows:
            entry = self._entry(value)
            self._rows[id(value)] = len(self.table)
            self._alive.append(value)  # so that no other value gets its id
            self.table.append(entry)
        return [self._rows[id(value)]]

    def _entry(self, value: Any) -> list[Any]:
        kind = type(value)
        if kind.__name__ in COLLECTIONS and kind is COLLECTIONS[kind.__name__]:
            return [kind.__name__, self._all(value)]
        if kind is dict or kind is ReadOnly:
            pairs = [[self.reference(key), self.reference(each)] for key, each in value.items()]
            return ["dict" if kind is dict else "read-only", pairs]
        if kind is bytes:
            return ["bytes", *self._placed(value)]
        if kind is complex:
            return ["complex", value.real, value.imag]
        if kind is Fraction:
            return ["fraction", value.numerator, value.denominator]
        if kind.__module__ == "numpy":
            return self._array(value)
        if isinstance(value, Enum):
            return ["enum", _name_of(kind), value.name]
        if isinstance(value, tuple):
            return ["named tuple", _name_of(kind), self._all(value)]
        if is_dataclass(kind):
            state = [[name, self.reference(each)] for name, each in _state_of(value).items()]
            return ["object", _name_of(kind), state]
        tag, parts = foreign_data.taken_apart(value)
        return [tag, *map(self.reference, parts)]

    def _all(self, values: Any) -> list[Any]:
        return [self.reference(each) for each in values]

    def _array(self, value: Any) -> list[Any]:
        import numpy as np  # Text is kept and read without it.

        if not isinstance(value, np.ndarray | np.generic):
            raise TypeError(f"{type(value)} of NumPy cannot be kept")
        array = np.asarray(value)
        if array.dtype.kind not in NUMERIC:
            raise TypeError(f"an array of {array.dtype} cannot be kept: it holds objects")
        turned = bool(array.flags.f_contiguous and not array.flags.c_contiguous)
        raw = (array.T if turned else array).tobytes()
        tag = "scalar" if isinstance(value, np.generic) else "turned" if turned else "array"
        return [tag, array.dtype.str, list(array.shape), *self._placed(raw)]

    def _placed(self, raw: bytes) -> tuple[int, int]:
        begin = len(self.raw)
        self.raw += raw
        return begin, len(raw)


@dataclass
class _Reader:
    raw: bytes
    made: list[Any] = field(default_factory=list)

    def value(self, reference: Any) -> Any:
        """Return a plain value, or what stands in a row that was read before."""
        if not isinstance(reference, list):
            return reference
        (row,) = reference
        if row < 0:
            raise DamagedError(f"there is no row {row}")
        return self.made[row]

    def entry(self, tag: str, *parts: Any) -> Any:
        """Make what stands in a row."""
        if tag in COLLECTIONS:
            (values,) = parts
            return COLLECTIONS[tag](map(self.value, values))
        makers: dict[str, Callable[..., Any]] = {
            "dict": self._pairs,
            "read-only": lambda pairs: ReadOnly(self._pairs(pairs)),
            "bytes": lambda begin, length: self.raw[begin : begin + length],
            "complex": complex,
            "fraction": Fraction,
            "array": self._array,
            "turned": lambda kind, shape, *place: self._array(kind, shape[::-1], *place).T,
            "scalar": lambda kind, shape, *place: self._array(kind, shape, *place)[()],
            "enum": lambda name, member: _own_type(name, Enum)[member],
            "named tuple": lambda name, values: _own_type(name, tuple)._make(map(self.value, values)),
            "object": self._object,
        }
        if tag in makers:
            return makers[tag](*parts)
        return foreign_data.put_together(tag, tuple(map(self.value, parts)))

    def _pairs(self, pairs: list[list[Any]]) -> dict[Any, Any]:
        return {self.value(key): self.value(each) for key, each in pairs}

    def _array(self, kind: str, shape: list[int], begin: int, length: int) -> Any:
        import numpy as np

        dtype = np.dtype(kind)
        if dtype.kind not in NUMERIC:
            raise DamagedError(f"an array of {dtype} holds objects")
        return np.frombuffer(self.raw[begin : begin + length], dtype).reshape(shape).copy()

    def _object(self, name: str, state: list[list[Any]]) -> Any:
        kind = _own_type(name, object)
        known = {each.name for each in fields(kind)}
        values = {key: self.value(each) for key, each in state}
        takes_more = hasattr(kind, "__setstate__")
        if not known <= values.keys() or (values.keys() - known and not takes_more):
            raise DamagedError(f"{name} has other fields")
        made: Any = object.__new__(kind)
        if takes_more:
            made.__setstate__(values)
        else:
            for key, value in values.items():
                object.__setattr__(made, key, value)
        return made


def _state_of(value: Any) -> dict[str, Any]:
    """Return the fields of a dataclass, or what it hands out itself, cached properties left out."""
    if not any("__getstate__" in vars(base) for base in type(value).__mro__ if base is not object):
        return {each.name: getattr(value, each.name) for each in fields(value)}
    known = {each.name for each in fields(value)}
    given = value.__getstate__().items()
    return {name: each for name, each in given if name in known or not hasattr(type(value), name)}


def _name_of(kind: type) -> str:
    """Return the name by which a type of this project is found again.

    Raises:
        TypeError: if it is none of those that are made again.
    """
    name = f"{kind.__module__}:{kind.__qualname__}"
    if _own_type(name, object) is not kind:
        raise TypeError(f"{name} cannot be kept: it is not found by its name")
    return name


@cache
def _own_type(name: str, base: type) -> Any:
    """Return an enumeration, a named tuple or a frozen dataclass of this project.

    Raises:
        TypeError: if it is none.
    """
    module, _, qualified = name.partition(":")
    parts = (*module.split("."), *qualified.split("."))
    if parts[0] not in PACKAGES or any(part.startswith("_") or not part.isidentifier() for part in parts):
        raise TypeError(f"{name} cannot be kept: it is no public type of this project")
    kind: Any = import_module(module)
    for part in qualified.split("."):
        kind = getattr(kind, part)
    if not isinstance(kind, type) or not issubclass(kind, base) or kind.__module__ != module:
        raise TypeError(f"{name} cannot be kept: it is no type of its own")
    is_frozen = is_dataclass(kind) and vars(kind)["__dataclass_params__"].frozen
    if not (is_frozen or issubclass(kind, Enum) or hasattr(kind, "_fields")):
        raise TypeError(f"{name} cannot be kept: it is no frozen dataclass, named tuple or enumeration")
    return kind
