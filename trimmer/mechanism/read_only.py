"""A mapping that keeps its order, cannot be changed, and can be pickled and hashed."""

from collections.abc import ItemsView, Iterator, Mapping, ValuesView
from typing import Generic, TypeVar

Value = TypeVar("Value")


class ReadOnly(Mapping[str, Value], Generic[Value]):
    """A read-only copy of a mapping by name."""

    __slots__ = ("_entries",)

    def __init__(self, entries: Mapping[str, Value]) -> None:
        self._entries = dict(entries)

    def __getitem__(self, name: str) -> Value:
        return self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __contains__(self, name: object) -> bool:
        return name in self._entries

    def items(self) -> ItemsView[str, Value]:
        """Return the names, each with its value."""
        return self._entries.items()

    def values(self) -> ValuesView[Value]:
        """Return the values."""
        return self._entries.values()

    def __hash__(self) -> int:
        return hash(frozenset(self._entries.items()))

    def __repr__(self) -> str:
        return repr(self._entries)
