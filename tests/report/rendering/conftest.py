"""One rendering of the sample report, and one browser, for all tests that look at them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from report.document import Document
from report.rendering.render import render
from report.rendering.request import Format
from tests.report.rendering.chromium import Connection, running
from tests.report.rendering.sample import sample

collect_ignore = [
    *("test_browser.py", "test_escaping.py", "test_latex.py", "test_markdown.py", "test_mathml.py"),
]
"""Written for the pages before they went by chapter; to be adapted to the new ones."""


@pytest.fixture(scope="session")
def document() -> Document:
    return sample()


@pytest.fixture(scope="session")
def rendered(document: Document, tmp_path_factory: pytest.TempPathFactory) -> Mapping[Format, Path]:
    return render(document, tmp_path_factory.mktemp("report") / "build")


@pytest.fixture(scope="session")
def browser(chromium: str) -> Iterator[Connection]:
    with running(chromium) as connection:
        yield connection
