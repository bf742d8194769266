"""Lines of keys in TOML texts whose numbers are the lines on which they stand."""

import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trimmer.mechanism.toml_lines import lines_of_keys

BLOCKS = (
    "{k} = {n}\n",
    "\t {k} = {n} # a = [1]\r\n",
    "\n# {k} = 0\n  {k}\t=\t{o}\n",
    '"{k} # ]=[ \\" µ" = {n}\n',
    '\'{k} "\' . b . "" = {n}\n',
    "{k}.a = {n}\n{k}.b = {m}\n",
    '{k} = {{ x = {n}, "y z".w = [{n}, {n}], v = {{}} }}\n',
    "{k} = [ # [\n  {m}, # ]\n\r\n  [{p}], ]\n",
    "{k} = [ {{ a = {n}, b = ']' }},\n {{ a = {m} }} ]\n",
    "{k} = ''''a''\n{k} = 0\n'''''\n",
    '{k} = """\\\n"" {k} = 0 \\""""""\n',
    "{k} = '#'\n",
    "{k} = true\n",
    "[ {k} . 'a.b' ]\nc = {m}\n[{k}.d]\ne = {p}\n",
    "[[{k}]]\nx = {m}\n[[{k}]]\n[{k}.b]\ny = {q}\n",
    "[[r]]\n[[r.s]]\n[r.s.t]\nz = {p}\n",
)


def values(value: object, place: tuple[str, ...] = ()) -> dict[tuple[str, ...], object]:
    """All places of a document: keys of tables, and entries of arrays by their number, with their values."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    found = {place: value}
    for key, each in inner:
        found |= values(each, (*place, str(key)))
    return found


@settings(max_examples=60)
@given(st.lists(st.sampled_from(BLOCKS)))
def test_every_number_stands_on_the_line_that_it_is(blocks: list[str]) -> None:
    text = ""
    for count, block in enumerate(blocks):
        n = text.count("\n") + 1
        text += block.format(k=f"k{count}", n=n, m=n + 1, o=n + 2, p=n + 3, q=n + 4)
    content, lines = values(tomllib.loads(text)), lines_of_keys(text)
    assert {()} | set(lines) == set(content)
    assert {place: line for place, line in lines.items() if type(content[place]) is int} == {
        place: value for place, value in content.items() if type(value) is int
    }


@given(st.text(st.sampled_from("a.\"'=[]{}#\n, 1-\\")))
def test_whatever_is_toml_can_be_read(text: str) -> None:
    try:
        content = tomllib.loads(text)
    except ValueError:
        return
    assert {()} | set(lines_of_keys(text)) == set(values(content))


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("\n[plays]\n# gap = 1\nbridge = { stiffness = 1, gap = 2 }", 4),
        ('s = """\ngap = 1\n"""\nplays.bridge.gap = 3', 4),
        ("[plays.bridge]\nbetween = [\n  'a', # [\n  'b',\n]\ngap = 3", 6),
        ('["plays"."bridge"]\r\n\r\n"gap" = 3', 3),
    ],
)
def test_the_line_of_a_gap(text: str, line: int) -> None:
    assert lines_of_keys(text)[("plays", "bridge", "gap")] == line


def test_a_table_stands_where_it_is_first_named() -> None:
    lines = lines_of_keys("\n[a]\nx = 1\n[b.c]\n[[d]]\n[[d]]\ny = 1\n[b]\n")
    assert lines == {("a",): 2, ("a", "x"): 3, ("b",): 4, ("b", "c"): 4, ("d",): 5, ("d", "0"): 5} | {
        ("d", "1"): 6, ("d", "1", "y"): 7
    }  # fmt: skip
