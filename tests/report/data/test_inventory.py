"""The inventory of statements and the sections they stand in, and that claims keep to it."""

import re
from collections import Counter
from pathlib import Path

import pytest

from report.building.collect import ClaimIdError, by_id, collect
from report.data.statements import FURTHER, PATH, ThesisSection, read_inventory, read_sections
from report.judging.claim import Kind
from report.judging.inventory import InventoryError, filed, read_statements
from report.judging.record import ClaimRecord
from report.judging.verdict import Certainty, Impact, Severity

HANDED_OVER = Path(__file__).parents[4] / "shared" / "inventory.csv"


def test_it_lists_every_statement_once():
    inventory = read_statements(PATH)
    assert len(inventory) == 253
    assert Counter(entry.kind.value for entry in inventory.values())["equation"] == 92


def test_it_is_the_one_handed_over():
    if not HANDED_OVER.is_file():
        pytest.skip("the inventory that was handed over is not beside this checkout")
    assert PATH.read_text(encoding="utf-8") == HANDED_OVER.read_text(encoding="utf-8")


def test_further_statements_follow_those_handed_over():
    handed_over, further = read_statements(PATH), read_statements(FURTHER)
    assert list(read_inventory()) == [*handed_over, *further]
    assert all(claim_id.startswith(f"txt-{entry.section}-") for claim_id, entry in further.items())
    assert {entry.chapter for entry in further.values()} <= {entry.chapter for entry in handed_over.values()}


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("eq-1,equation,1,a\neq-1,equation,1,b\n", r"line 3: the id eq-1 stands there twice"),
        ("eq-2.1,equation,2.2.1,a\n", r"line 2: the id eq-2\.1 stands there twice"),
        ("eq-1,poem,1,a\n", r"line 2: unknown kind 'poem'"),
    ],
)
def test_faults_are_named_by_line(tmp_path, rows, message):
    path = tmp_path / "inventory.csv"
    path.write_text("id,kind,section,subject\n" + rows, encoding="utf-8")
    with pytest.raises(InventoryError, match=rf"inventory\.csv, {message}"):
        read_statements(PATH, path)


ASCII_MATHEMATICS = re.compile(
    r"\b(omega|beta|gamma|alpha|lambda|phi)\b|[A-Za-z]_|\d[eE]-?\d|\w=\w|-1/N|\bDFs?\b"
)


def test_titles_have_no_ascii_mathematics():
    titles = {key: entry.title for key, entry in read_inventory().items()}
    assert titles["eq-2.40"] == "b₁ of friction-controlled backlash"
    assert {key: title for key, title in titles.items() if ASCII_MATHEMATICS.search(title)} == {}


HEAD = "id,source,impact,first_line,last_line,paragraph,severity,certainty,title\n"


def statement(tmp_path, rows):
    path = tmp_path / "claims.csv"
    path.write_text(HEAD + rows, encoding="utf-8")
    return filed({"eq-2.1": read_statements(PATH)["eq-2.1"]}, path)["eq-2.1"]


def test_a_table_says_what_is_known_of_a_statement(tmp_path):
    full = statement(tmp_path, "eq-2.1,a.py,local,3,7,2,result,proven,A title\n")
    assert (full.source, full.impact, full.lines, full.paragraph) == ("a.py", Impact.LOCAL, (3, 7), 2)
    assert (full.severity, full.certainty, full.title) == (Severity.RESULT, Certainty.PROVEN, "A title")
    bare = statement(tmp_path, "eq-2.1,a.py,,,,,,,\n")
    assert (bare.impact, bare.lines, bare.paragraph) == (Impact.NONE, None, None)
    assert (bare.severity, bare.certainty, bare.title) == (None, None, "pin displacement input")


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("", r"claims\.csv: has one line for each statement; see eq-2\.1"),
        ("eq-2.1,a,,,,,,,\neq-2.1,a,,,,,,,\n", r"claims\.csv: has one line for each statement; see eq-2\.1"),
        ("eq-2.1,a,,,,,,,\neq-9,a,,,,,,,\n", r"statement; see eq-9$"),
        ("eq-2.1,a,,1,,,,,\n", r"claims\.csv, line 2: last_line '' is no number of a line"),
        ("eq-2.1,a,,1,2,,bad,,\n", r"claims\.csv, line 2: severity 'bad' is not known"),
    ],
)
def test_a_table_has_one_line_for_each_statement(tmp_path, rows, message):
    with pytest.raises(InventoryError, match=message):
        statement(tmp_path, rows)


def record(claim_id):
    return ClaimRecord(claim_id, lambda _: iter(()))


def test_unknown_and_repeated_ids_are_errors():
    inventory = read_inventory()
    assert list(by_id([("a", record("eq-2.1")), ("b", record("eq-2.2"))], inventory)) == ["eq-2.1", "eq-2.2"]
    with pytest.raises(ClaimIdError, match=r"^chapter_2: eq-9\.99 is not in the inventory; add a line"):
        by_id([("chapter_2", record("eq-9.99"))], inventory)
    with pytest.raises(ClaimIdError, match=r"eq-2\.1 stands twice, in chapter_1 and chapter_2"):
        by_id([("chapter_1", record("eq-2.1")), ("chapter_2", record("eq-2.1"))], inventory)


def test_a_statement_without_a_record_is_an_error():
    inventory = read_inventory()
    with pytest.raises(ClaimIdError, match=r"^txt-trial: in the inventory, but without a record"):
        collect({**inventory, "txt-trial": inventory["eq-2.1"]})


@pytest.fixture(scope="module")
def sections() -> tuple[ThesisSection, ...]:
    return read_sections()


def test_every_section_of_the_inventory_has_a_title(sections, inventory) -> None:
    numbers = Counter(section.number for section in sections)
    assert set(numbers.values()) == {1}
    assert {entry.section for entry in inventory.values() if "." in entry.section} <= set(numbers)
    assert all(section.title for section in sections)


def test_every_figure_stands_in_one_section_of_its_chapter(sections, inventory) -> None:
    placed = {figure: section for section in sections for figure in section.figures}
    figures = {id: each for id, each in inventory.items() if each.kind is Kind.FIGURE}
    numbered = {id: each for id, each in figures.items() if each.chapter.isdigit()}
    assert set(placed) == set(numbered)
    assert sum(len(section.figures) for section in sections) == len(placed)
    for id, entry in numbered.items():
        assert f"{placed[id].number}.".startswith(f"{entry.section}."), id


def test_figures_are_numbered_in_the_order_of_the_sections(sections: tuple[ThesisSection, ...]) -> None:
    figures = [figure for section in sections for figure in section.figures]
    numbers = [[int(part) for part in figure[4:].split(".")] for figure in figures]
    assert numbers == sorted(numbers)
