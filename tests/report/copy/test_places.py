"""A reader's copy is taken if it is the text that was judged; sections and paragraphs are found in it."""

import hashlib

import pytest

from report.copy.blocks import BlockKind
from report.copy.places import Places
from report.copy.reading import CopyFileError, OtherCopyError, read_reader_copy
from tests.report.copy.made_up import LINES, TEXT, line_of

PLACES = Places(LINES)


def test_sections_hold_what_is_below_them():
    appendix = line_of("Appendix A")
    assert PLACES.sections == {
        "1": (3, appendix - 1),
        "1.1": (line_of("1.1 Motion"), line_of("1.2 Numbers") - 1),
        "1.2": (line_of("1.2 Numbers"), appendix - 1),
        "A": (appendix, len(LINES)),
        "A.1": (line_of("A.1 The"), len(LINES)),
    }


def test_numbered_things_are_found_with_all_that_belongs_to_them():
    assert PLACES.numbered == {
        "eq-1.1": (line_of("(1.1)"), line_of("(1.1)")),
        "eq-1.2": (line_of("y &=") - 1, line_of("1.2}")),
        "fig-1.1": (line_of("Figure 1.1:"), line_of("Figure 1.1:")),
        "fig-1.2": (line_of("Figure 1.2:"), line_of("Figure 1.2:")),
        "tab-1.1": (line_of("Table 1.1"), line_of("4\t4.0")),
        "lst-A.1": (line_of("Listing A.1"), line_of("3 z = 3") + 1),
    }


def test_formulas_without_a_number_are_listed():
    assert PLACES.unnumbered_formulas("1.1") == ((line_of("z = 4x"), line_of("z = 4x")),)
    assert PLACES.unnumbered_formulas("A.1") == ()


def test_paragraphs_are_counted_after_each_heading():
    assert [(each.section, each.number, each.begins[:12]) for each in PLACES.paragraphs] == [
        ("1", 1, "They swing."),
        ("1.1", 1, "A pendulum h"),
        ("1.1", 1, "to and fro. "),  # a figure stands in the middle of the sentence
        ("1.1", 2, "where x is i"),
        ("1.1", 3, "² and nothin"),  # a footnote's mark, not a footnote
        ("1.1", 4, "(a) says mor"),
        ("1.1", 5, "It begins an"),
        ("1.2", 1, "Both were me"),
        ("A.1", 1, "Nothing foll"),
    ]


@pytest.mark.parametrize(
    ("words", "expected"),
    [("(1.1)", ("1.1", 1)), ("z = 4x", ("1.1", 5)), ("They swing", ("1", 1)), ("1 x = 1", None)],
)
def test_a_line_is_in_the_paragraph_or_after_it(words, expected):
    found = PLACES.paragraph_at(line_of(words))
    assert (found and (found.section, found.number)) == expected


def test_a_title_and_a_subheading_are_no_text():
    kinds = {block.text: block.kind for block in PLACES.blocks}
    assert kinds["Where pendulums come from and go to"] is BlockKind.SUBHEADING
    assert kinds["Without friction"] is BlockKind.SUBHEADING
    assert kinds["(a) Left"] is BlockKind.CAPTION
    assert kinds["¹Only if it swings little"] is BlockKind.FOOTNOTE


DIGEST = hashlib.sha256(TEXT.encode()).hexdigest()


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "copy.txt"
    path.write_bytes(TEXT.encode())
    return path


def test_the_text_that_was_judged_is_taken(file):
    copy = read_reader_copy(file, DIGEST)
    assert copy.is_judged
    assert copy.sha256 == DIGEST
    assert list(copy.lines) == LINES
    assert copy.passage((3, 5)) == ("Chapter 1", "", "Where pendulums come from and go to")
    assert copy.passage((len(LINES), len(LINES) + 9)) == ("Nothing follows.",)
    assert copy.passage((len(LINES) + 1, len(LINES) + 1)) == ()


def test_another_text_is_refused_with_both_digests_and_what_to_do(file):
    file.write_text(TEXT + "!", encoding="utf-8")
    digest = hashlib.sha256((TEXT + "!").encode()).hexdigest()
    with pytest.raises(OtherCopyError) as refused:
        read_reader_copy(file, DIGEST)
    message = str(refused.value)
    assert all(word in message for word in (str(file), digest, DIGEST, "--other-copy"))
    other = read_reader_copy(file, DIGEST, accept_other=True)
    assert not other.is_judged
    assert other.lines[-1] == "Nothing follows.!"


@pytest.mark.parametrize("content", [b"\xff\xfe", b"first\nsecond \x80", "é".encode("latin-1")])
def test_what_is_not_utf_8_is_refused_with_its_line(tmp_path, content):
    path = tmp_path / "copy.txt"
    path.write_bytes(content)
    with pytest.raises(CopyFileError, match=rf"copy\.txt.*UTF-8.*line {content.count(10) + 1}"):
        read_reader_copy(path, DIGEST, accept_other=True)


def test_what_cannot_be_read_is_named(tmp_path):
    for path in (tmp_path, tmp_path / "none.txt"):
        with pytest.raises(CopyFileError, match=f"{path}: cannot be read: "):
            read_reader_copy(path, DIGEST)


@pytest.mark.parametrize(
    ("content", "lines"),
    [
        (b"one\r\ntwo\r\n", ("one", "two")),
        (b"\xef\xbb\xbfone\ntwo", ("one", "two")),
        ("one\u2028still\x0cone\ntwo\n".encode(), ("one\u2028still\x0cone", "two")),
        (b"", ("",)),
    ],
)
def test_lines_are_those_of_an_editor(tmp_path, content, lines):
    path = tmp_path / "copy.txt"
    path.write_bytes(content)
    assert read_reader_copy(path, DIGEST, accept_other=True).lines == lines
