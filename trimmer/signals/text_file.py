"""Text files of measuring devices: their encoding, and the refusal of files that are no text."""

import re
from pathlib import Path

from trimmer.files import read_content
from trimmer.messages import near_file
from trimmer.signals.signal import SignalError

_UTF_16_MARKS = (b"\xff\xfe", b"\xfe\xff")
_OTHER_FILES = (
    (b"PK\x03\x04", "a spreadsheet or another zip file"),
    (b"\xd0\xcf\x11\xe0", "an old spreadsheet"),
    (b"\x1f\x8b", "a gzip file"),
    (b"\x89HDF", "an HDF5 file, such as a MATLAB file"),
    (b"MATLAB 5.0", "a MATLAB file"),
    (b"%PDF", "a PDF file"),
)
_CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


class SignalFileError(SignalError):
    """A file of samples that cannot be used; the message begins with the file, and the line if any."""


def read_lines(path: Path) -> list[str]:
    """Return the lines of a text file, without their ends.

    UTF-8 with or without byte order mark; what is not UTF-8 is taken as Latin-1, in which every byte is a
    character, so only letters outside ASCII can come out wrong, never a number.
    """
    content = _content(path)
    if content.startswith(b"RIFF"):
        raise SignalFileError(f"{path}: is a RIFF file, such as WAV; name it as a file, or use read_wav")
    for start, kind in _OTHER_FILES:
        if content.startswith(start):
            raise SignalFileError(f"{path}: is {kind}; export the samples as CSV text")
    if content.startswith(_UTF_16_MARKS):
        raise SignalFileError(f"{path}: is UTF-16 text; save it as UTF-8 ('CSV UTF-8' in a spreadsheet)")
    control = _CONTROL.search(content)
    if control is not None:
        line = content.count(b"\n", 0, control.start()) + 1
        raise SignalFileError(
            f"{path}, line {line}: byte 0x{control[0][0]:02x} does not occur in CSV text; "
            "is it a binary file, or UTF-16?"
        )
    text = _decoded(content)
    if not text.strip():
        raise SignalFileError(f"{path}: is empty; a column of samples is needed")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _content(path: Path) -> bytes:
    try:
        return read_content(path)
    except OSError as error:
        raise unreadable(path, error) from error


def unreadable(path: Path, error: OSError) -> SignalFileError:
    """Return the error that says why a file cannot be read."""
    if isinstance(error, FileNotFoundError):
        advice = near_file(path) or "name a file of samples"
        return SignalFileError(f"{path}: no such file; {advice}")
    if isinstance(error, IsADirectoryError):
        return SignalFileError(f"{path}: is a folder; name the file of samples in it")
    return SignalFileError(f"{path}: cannot be read: {error.strerror or error}; name a file of samples")


def _decoded(content: bytes) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")
