"""Pieces of the report that are kept: only what has changed is converted and set again."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.rendering import pandoc
from report.rendering.markdown import to_markdown
from report.rendering.render import render
from report.rendering.request import Format, Request
from report.rendering.selection import select

HTML = Request(formats=frozenset({Format.HTML}))


@pytest.fixture(scope="module")
def part(document: Document) -> Document:
    return select(document, ["ch5", "appA"])


@pytest.fixture
def store(tmp_path: Path) -> StageStore:
    return StageStore(tmp_path / "kept")


@pytest.fixture
def converted(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What pandoc was given in the test so far."""
    given: list[str] = []
    run = pandoc._run

    def noted(content: bytes, arguments: Sequence[str]) -> bytes:
        given.append(content.decode())
        return run(content, arguments)

    monkeypatch.setattr(pandoc, "_run", noted)
    return given


def test_an_unchanged_report_is_written_without_pandoc_and_typst(
    part: Document,
    store: StageStore,
    converted: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = {form: path.read_bytes() for form, path in render(part, tmp_path / "1", store=store).items()}
    assert len(converted) == 3 * len(to_markdown(part))  # each piece is read, written as HTML and as Typst
    converted.clear()
    monkeypatch.setattr("typst.compile", None)
    second = {form: path.read_bytes() for form, path in render(part, tmp_path / "2", store=store).items()}
    assert converted == []
    assert second == first


@pytest.mark.slow
def test_only_the_section_that_has_changed_is_converted(
    part: Document, store: StageStore, converted: list[str], tmp_path: Path
) -> None:
    render(part, tmp_path, HTML, store)
    converted.clear()
    five, appendix = part.chapters
    finding = dataclasses.replace(appendix.findings[0], explanation="It is explained anew.")
    chapters = (five, dataclasses.replace(appendix, findings=(finding,)))
    page = render(dataclasses.replace(part, chapters=chapters), tmp_path, HTML, store)[Format.HTML]
    assert "It is explained anew." in page.read_text(encoding="utf-8")
    read, written = converted
    assert "It is explained anew" in read
    assert written.startswith("{")
