"""Results of a design that are kept between runs, each under a key of all that it depends on."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

Result = TypeVar("Result")


class Store(Protocol):
    """Keeps results by name and key, each whole or not at all."""

    def load(self, stage: str, key: str) -> Any | None:
        """Return what was kept, or None if there is nothing under this key."""
        ...

    def keep(self, stage: str, key: str, result: object) -> None:
        """Keep a result, which is not None."""
        ...


@dataclass(frozen=True)
class Keeper:
    """Keeps the stages of a design in a store, or nowhere; ``depends`` is what every stage depends on."""

    store: Store | None = None
    depends: str = ""

    def made(self, stage: str, depends: object, make: Callable[[], Result]) -> Result:
        """Return what was kept of a stage, or make it and keep it; ``repr`` says all that it depends on."""
        kept: Result | None = self.kept(stage, depends)
        if kept is None:
            kept = make()
            self.keep(stage, depends, kept)
        return kept

    def keep(self, stage: str, depends: object, result: object) -> None:
        """Keep a stage, which is not None."""
        if self.store is not None:
            self.store.keep(*self._place(stage, depends), result)

    def kept(self, stage: str, depends: object) -> Any | None:
        """Return what was kept of a stage; None if there is nothing."""
        name, key = self._place(stage, depends)
        return None if self.store is None else self.store.load(name, key)

    def _place(self, stage: str, depends: object) -> tuple[str, str]:
        """Return name and key; the name has a part of the key, so that two designs share a folder."""
        key = hashlib.sha256(f"{stage}\0{self.depends}\0{depends!r}".encode()).hexdigest()
        return f"{stage}-{key[:20]}", key


NOT_KEPT = Keeper()  # Keeps nothing
