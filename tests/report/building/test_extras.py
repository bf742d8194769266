"""Extra chapters: what makes them and where the document has them agree."""

from importlib import import_module

from report.building.extras import EXTRAS
from report.document import document


def test_each_chapter_of_the_document_is_made_and_no_other() -> None:
    assert sorted(extra.name for extra in EXTRAS) == sorted(document.EXTRAS)


def test_the_module_that_each_depends_on_is_there() -> None:
    assert all(import_module(extra.module) for extra in EXTRAS)
