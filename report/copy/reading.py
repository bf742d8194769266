"""Reading the reader's own text copy of the thesis, and comparing it with the one that was judged."""

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import final

from trimmer.errors import TrimmerError
from trimmer.files import read_content

SHOWN_BYTES = 4


class CopyFileError(TrimmerError, OSError):
    """The text copy cannot be read, or is no text in UTF-8."""


class OtherCopyError(TrimmerError, ValueError):
    """The text copy is another one than the one that was judged."""


@final
@dataclass(frozen=True)
class ReaderCopy:
    """The reader's own text copy."""

    lines: tuple[str, ...]  # Of the text, without their ends
    sha256: str  # Of the file's bytes, in hexadecimal digits
    is_judged: bool  # Whether it is the text that was judged, byte by byte

    def passage(self, lines: tuple[int, int]) -> tuple[str, ...]:
        """Return the lines from the first to the last of a pair, as far as the copy has them."""
        first, last = lines
        return self.lines[first - 1 : last]


def read_reader_copy(path: Path, judged: str, *, accept_other: bool = False) -> ReaderCopy:
    """Read a text copy, which is the one that was judged, by its SHA-256, unless another one is accepted.

    It is UTF-8; a byte-order mark is left out of the text, not of the digest.

    Raises:
        CopyFileError: naming the file, if it cannot be read, or is not UTF-8.
        OtherCopyError: naming the file and both digests, if it is another text and that is not accepted.
    """
    try:
        content = read_content(path)
    except OSError as error:
        raise CopyFileError(f"--thesis {path}: cannot be read: {error.strerror or error}") from error
    lines = split(_decoded(content, f"--thesis {path}"))
    digest = hashlib.sha256(content).hexdigest()
    if digest != judged and not accept_other:
        raise OtherCopyError(
            f"--thesis {path}: is another text than the one that was judged: its SHA-256 is {digest}, that "
            f"of the text judged {judged}; give that text, or add --other-copy to show this one, whose lines "
            "may not fit"
        )
    return ReaderCopy(lines, digest, digest == judged)


def read_judged_text(path: Path) -> ReaderCopy:
    """Read a text that is judged itself.

    Raises:
        CopyFileError: naming the file, if it cannot be read, or is not UTF-8.
    """
    try:
        content = read_content(path)
    except OSError as error:
        raise CopyFileError(f"{path}: cannot be read: {error.strerror or error}") from error
    return ReaderCopy(
        split(_decoded(content, str(path))), hashlib.sha256(content).hexdigest(), is_judged=True
    )


def split(text: str) -> tuple[str, ...]:
    """Return the lines of a text, as an editor counts them; nothing but a line feed ends a line."""
    lines = text.removesuffix("\n").split("\n")
    return tuple(line.removesuffix("\r") for line in lines)


def _decoded(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        found = content[error.start : error.start + SHOWN_BYTES].hex(" ")
        raise CopyFileError(
            f"{name}: is no text in UTF-8 (line {line} has the bytes {found}): give the text copy, "
            "not the PDF, and save it as UTF-8"
        ) from error
