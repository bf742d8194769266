import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.mechanism.toml_texts import toml_texts
from trimmer.mechanism.toml_lines import lines_of_keys


def places(value: object, place: tuple[str, ...] = ()) -> set[tuple[str, ...]]:
    """All places of a document: keys of tables, and entries of arrays by their number."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return {place}.union(*(places(each, (*place, str(key))) for key, each in inner))


@settings(max_examples=20)
@given(toml_texts())
def test_every_key_is_found_on_its_line(written: tuple[str, dict, dict]) -> None:
    text, content, lines = written
    assert tomllib.loads(text) == content
    assert lines_of_keys(text) == lines
    assert set(lines) == places(content) - {()}


@given(st.text(st.sampled_from("a.\"'=[]{}#\n, 1-\\")))
def test_whatever_is_toml_can_be_read(text: str) -> None:
    try:
        content = tomllib.loads(text)
    except ValueError:
        return
    assert set(lines_of_keys(text)) == places(content) - {()}


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("\n[plays]\n# gap = 1\nbridge = { stiffness = 1, gap = 2 }", 4),
        ('s = """\ngap = 1\n"""\nplays.bridge.gap = 3', 4),
        ("[plays.bridge]\nbetween = [\n  'a', # [\n  'b',\n]\ngap = 3", 6),
        ('["plays"."bridge"]\r\n\r\n"gap" = 3', 3),
        ("s = '''''a'''''\n[ plays . bridge ]\ngap = 3", 3),
        ('s = """a\\""""""\n[plays]\nbridge = {gap = 3}', 3),
    ],
)
def test_the_line_of_a_gap(text: str, line: int) -> None:
    assert lines_of_keys(text)[("plays", "bridge", "gap")] == line


def test_tables_of_an_array_below_one_another() -> None:
    text = "[[a]]\nx = 1\n[[a]]\n[a.b]\ny = 1\n[[a.c]]\nz = 2\n[[a.c]]\nz = 3\n[[a]]\n[[a.c]]\n"
    assert set(lines_of_keys(text)) == places(tomllib.loads(text)) - {()}
    assert lines_of_keys(text)["a", "1", "c", "1", "z"] == 9
    assert lines_of_keys(text)["a", "2", "c", "0"] == 11
