from collections import Counter
from collections.abc import Mapping

import pytest

from report.data.statements import ThesisSection, read_sections
from report.judging.claim import Kind, Statement


@pytest.fixture(scope="module")
def sections() -> tuple[ThesisSection, ...]:
    return read_sections()


def test_every_section_of_the_inventory_has_a_title(
    sections: tuple[ThesisSection, ...], inventory: Mapping[str, Statement]
) -> None:
    numbers = Counter(section.number for section in sections)
    assert set(numbers.values()) == {1}
    assert {entry.section for entry in inventory.values() if "." in entry.section} <= set(numbers)
    assert all(section.title for section in sections)


def test_every_figure_stands_in_one_section_of_its_chapter(
    sections: tuple[ThesisSection, ...], inventory: Mapping[str, Statement]
) -> None:
    placed = {figure: section for section in sections for figure in section.figures}
    numbered = {
        id: entry for id, entry in inventory.items() if entry.kind is Kind.FIGURE and entry.chapter.isdigit()
    }
    assert set(placed) == set(numbered)
    assert sum(len(section.figures) for section in sections) == len(placed)
    for id, entry in numbered.items():
        assert f"{placed[id].number}.".startswith(f"{entry.section}."), id


def test_figures_are_numbered_in_the_order_of_the_sections(sections: tuple[ThesisSection, ...]) -> None:
    numbers = [
        [int(part) for part in figure[4:].split(".")] for section in sections for figure in section.figures
    ]
    assert numbers == sorted(numbers)
