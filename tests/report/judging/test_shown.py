"""Numbers and formulas that a report shows: ``shown.py`` says what is kept of them and renews it."""

import pytest

from tests.report.shown import FOLDER, texts
from tests.trimmer.command_line.alike import alike


@pytest.fixture(scope="module")
def found(evidence, findings):
    return texts(evidence, findings)


def test_a_file_is_kept_of_each_chapter(found):
    assert {path.stem for path in FOLDER.glob("*.txt")} == set(found)


@pytest.mark.parametrize("name", sorted(path.stem for path in FOLDER.glob("*.txt")))
def test_numbers_and_formulas_are_shown_as_they_were(name, found):
    kept, now = (_by_heading(text) for text in ((FOLDER / f"{name}.txt").read_text("utf-8"), found[name]))
    assert list(now) == list(kept)
    assert {head: now[head] for head in kept if not alike(kept[head], now[head])} == {}


def _by_heading(text):
    return {head: rest for head, _, rest in (each.partition("\n") for each in text.split("# ")[1:])}
