"""One rendering of the sample report, and one browser, for all tests that look at them."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.pages.formats import Format
from report.rendering.render import render
from tests.report.made_once import MadeOnce
from tests.report.rendering.page_checks import Visit, lead, opened, visited
from tests.report.rendering.sample import sample


@pytest.fixture(scope="session")
def document() -> Document:
    return sample()


@pytest.fixture(scope="session")
def rendered(document: Document, tmp_path_factory, made_once: MadeOnce) -> Mapping[Format, Path]:
    folder = (made_once.lasting or tmp_path_factory.mktemp("report")) / "sample"
    store = StageStore(folder / "kept")
    sources = sorted(map(str, Path(__file__).parent.glob("sample*.py")))
    return made_once.of_sources("rendered", lambda: render(document, folder / "build", store=store), *sources)


@pytest.fixture(scope="session")
def address(rendered: Mapping[Format, Path]) -> str:
    return rendered[Format.HTML].as_uri()


@pytest.fixture
def visit(browser: Browser, address: str) -> Iterator[Callable[..., Visit]]:
    """Open the sample in a page of its own: ``visit(end, width=…, scheme=…, scripts=…)``.

    ``end`` follows its address. No page has anything of another test's, so that none fails for another.
    """
    with ExitStack() as pages:

        def load(end: str = "", scripts: bool = True, **options: object) -> Visit:
            visit = pages.enter_context(opened(browser, scripts))
            lead(visit, address + end, **options)
            return visit

        yield load


@pytest.fixture(scope="module")
def shared(browser: Browser, address: str) -> Iterator[Page]:
    """The sample in one page for the tests of a file that need nothing of what is before.

    Each of them begins with what undoes the others: it searches, focuses or moves anew.
    """
    with visited(browser, address) as visit:
        yield visit.page
