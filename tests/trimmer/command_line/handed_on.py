"""Stand-ins for functions of the library, which keep what they are called with."""

from __future__ import annotations

from typing import Any

import pytest


class Called:
    """Stands for a function, keeps its arguments, and returns or raises what it was made with."""

    def __init__(self, result: Any = None) -> None:
        self.result = result
        self.arguments: tuple[Any, ...] = ()
        self.keywords: dict[str, Any] = {}

    def __call__(self, *arguments: Any, **keywords: Any) -> Any:
        self.arguments, self.keywords = arguments, keywords
        if isinstance(self.result, BaseException):
            raise self.result
        return self.result


def as_words(monkeypatch: pytest.MonkeyPatch, module: str) -> None:
    """Let a command tell its result in two words."""
    monkeypatch.setattr(f"trimmer.command_line.{module}.as_text", lambda *_: "told")
    monkeypatch.setattr(f"trimmer.command_line.{module}.as_json", lambda *_: "data")
