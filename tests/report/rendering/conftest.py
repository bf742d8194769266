"""One rendering of the sample report, and one browser, for all tests that look at them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from report.document import Document
from report.rendering.render import render
from report.rendering.request import Format
from tests.report.rendering.page_checks import Visit, chromium_browser, visited
from tests.report.rendering.sample import sample


@pytest.fixture(scope="session")
def document() -> Document:
    return sample()


@pytest.fixture(scope="session")
def rendered(document: Document, tmp_path_factory: pytest.TempPathFactory) -> Mapping[Format, Path]:
    return render(document, tmp_path_factory.mktemp("report") / "build")


@pytest.fixture(scope="session")
def address(rendered: Mapping[Format, Path]) -> str:
    return rendered[Format.HTML].as_uri()


@pytest.fixture(scope="session")
def browser(chromium: str) -> Iterator[Browser]:
    with chromium_browser(chromium) as browser:
        yield browser


@pytest.fixture
def visit(browser: Browser, address: str) -> Iterator[Callable[..., Visit]]:
    """Open the sample report: ``visit(end, width=…, scheme=…, scripts=…)``; ``end`` follows its address."""
    with ExitStack() as stack:

        def open_page(end: str = "", **options: object) -> Visit:
            return stack.enter_context(visited(browser, address + end, **options))

        yield open_page
