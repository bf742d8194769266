"""Pieces of the report that are kept: only what has changed is converted and set again."""

import dataclasses
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.pages.formats import Format
from report.rendering.render import render
from report.rendering.request import Request
from report.rendering.selection import select

HTML = Request(formats=frozenset({Format.HTML}))


@pytest.fixture(scope="module")
def part(document: Document) -> Document:
    return select(document, ["appA"])


@pytest.fixture
def store(tmp_path: Path) -> StageStore:
    return StageStore(tmp_path / "kept")


def test_an_unchanged_report_is_written_without_pandoc_and_typst(part, store, tmp_path, monkeypatch) -> None:
    """Without both tools everything comes from what is kept; what has changed asks for them."""
    first = {form: path.read_bytes() for form, path in render(part, tmp_path / "1", store=store).items()}
    monkeypatch.setattr("typst.compile", None)
    monkeypatch.setattr("pypandoc.get_pandoc_path", lambda: "no-such-pandoc")
    second = {form: path.read_bytes() for form, path in render(part, tmp_path / "2", store=store).items()}
    assert second == first
    (appendix,) = part.chapters
    finding = dataclasses.replace(appendix.findings[0], explanation="It is explained anew.")
    chapters = (dataclasses.replace(appendix, findings=(finding,)),)
    with pytest.raises(FileNotFoundError, match="no-such-pandoc"):
        render(dataclasses.replace(part, chapters=chapters), tmp_path, HTML, store)
    monkeypatch.undo()
    page = render(dataclasses.replace(part, chapters=chapters), tmp_path, HTML, store)[Format.HTML]
    assert "It is explained anew." in page.read_text(encoding="utf-8")
