"""The library's functions and the writer of pictures, replaced for a test."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.trimmer.command_line.handed_on import Called


@pytest.fixture
def replaced(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Called]:
    def replace(place: str, result: Any = None) -> Called:
        called = Called(result)
        monkeypatch.setattr(place, called)
        return called

    return replace


@pytest.fixture
def written(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What is given to the writer of pictures, instead of a picture."""
    drawn: list[Any] = []
    monkeypatch.setattr(
        "trimmer.drawing.content.content_of", lambda figure, ending: drawn.append(figure) or b""
    )
    return drawn
