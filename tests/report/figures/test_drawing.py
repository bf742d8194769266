"""What tells two drawings apart, so that a kept figure is drawn again when it would look different."""

from __future__ import annotations

from typing import Any

from report.drawing.drawing import Drawing


def draw(evidence: Any, width: float = 1.0) -> Any:
    raise AssertionError("nothing is drawn here")


def drawing(function: Any) -> Drawing:
    return Drawing("fig-1.1", "a title", "A caption.", "words", function)


def test_a_lambda_is_told_by_what_it_calls_and_with_which_numbers() -> None:
    narrow, wide = drawing(lambda known: draw(known, 1.0)), drawing(lambda known: draw(known, 2.0))
    assert narrow.modules == wide.modules == {draw.__module__}
    assert narrow.words != wide.words
    assert narrow.words == drawing(lambda known: draw(known, 1.0)).words


def test_a_function_is_told_by_its_module() -> None:
    assert drawing(draw).modules == {draw.__module__}
    assert drawing(draw).words == drawing(draw).words


def test_the_words_count() -> None:
    assert drawing(draw).words != Drawing("fig-1.1", "a title", "Another caption.", "words", draw).words
