"""A reader's copy is taken if it is the text that was judged; another one only on demand."""

import hashlib

import pytest

from report.copy.reading import CopyFileError, OtherCopyError, read_reader_copy
from tests.report.copy.made_up import LINES, TEXT

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
