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
