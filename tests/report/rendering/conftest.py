"""One rendering of the sample report, and one browser, for all tests that look at them."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
from playwright.sync_api import Page

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.pages.formats import Format
from report.rendering.render import render
from tests.report.made_once import MadeOnce
from tests.report.rendering.page_checks import Visit, lead
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
def visit(window: Callable[..., Visit], address: str) -> Callable[..., Visit]:
    """Bring a page to the sample: ``visit(end, width=…, scheme=…, scripts=…)``; ``end`` follows its address.

    What is left of another test is gone then, so that none fails for another.
    """

    def load(end: str = "", scripts: bool = True, **options: object) -> Visit:
        return lead(window(scripts), address + end, **options)

    return load


@pytest.fixture(scope="module")
def shared(window: Callable[..., Visit], address: str) -> Page:
    """The sample in one page for the tests of a file that need nothing of what is before.

    Each of them begins with what undoes the others: it searches, focuses or moves anew.
    """
    return lead(window(True, "shared"), address).page
