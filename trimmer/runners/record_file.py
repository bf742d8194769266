"""A file that keeps results as soon as they are done: a header with what they depend on, then a line each.

Each line is JSON, and the header is the first. A line counts as soon as its end is there, so what a killed
run leaves half-written is dropped.
"""

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trimmer.errors import MapFileError
from trimmer.files import FileKind, FileWriteError, is_standard_output, is_stream, write_atomically
from trimmer.json_data import DataError, parsed_json
from trimmer.messages import shown_value
from trimmer.runners.runner import Result


@dataclass(frozen=True)
class RecordFile:
    """A kind of file of results: its header, and what its lines are called."""

    kind: FileKind  # How such a file begins
    key: str  # The key of the header that tells the kind; its value is the version of the format
    version: int  # The version that is written
    many: str  # What the file holds, for messages, such as ``map`` or ``samples``
    one: str  # What a line is, such as ``cell of a map``
    # What a file may have been begun with, by the key of its header in which that shows
    others: Mapping[str, str]

    def begin(self, path: Path, header: Mapping[str, Any], *, overwrite: bool = False) -> None:
        """Write a file with the header alone."""
        if is_stream(path) or is_standard_output(path):
            raise MapFileError(f"{path} is a stream, with which no {self.many} can go on: name a file")
        if not overwrite and path.is_file():
            with path.open("rb") as file:
                if self.kind.begins.match(file.readline()):
                    raise MapFileError(
                        f"{path} is a {self.kind.name} already: go on with it (--resume), or replace it "
                        "(--overwrite)"
                    )
        write_atomically(path, as_line(header), overwrite=overwrite)

    def header(self, path: Path) -> dict[str, Any]:
        """Return the header of a file."""
        return self._header(path, _whole_lines(path))

    def entries(self, path: Path, wanted: Mapping[str, Any]) -> Iterator[tuple[int, Any]]:
        """Yield the numbers of the lines after the header, with what they hold."""
        lines = _whole_lines(path)
        header = self._header(path, lines)
        for name, what in self.others.items():
            if header.get(name) != wanted[name]:
                raise MapFileError(
                    f"{path} was begun with {what}: go on with what it was begun with, "
                    "or begin it anew (--overwrite)"
                )
        for number, line in enumerate(lines[1:], start=2):
            try:
                yield number, parsed_json(line)
            except DataError as error:
                raise self.damaged(path, number, error) from error

    def damaged(self, path: Path, number: int, reason: Exception | str) -> MapFileError:
        """Return the error that says that a line is none of these, and why."""
        return MapFileError(
            f"{path}, line {number}: is no {self.one} ({reason}); take the line out to have it done again, "
            "or begin anew (--overwrite)"
        )

    def _header(self, path: Path, lines: list[bytes]) -> dict[str, Any]:
        try:
            header = parsed_json(lines[0]) if lines else None
        except DataError:
            header = None
        if not isinstance(header, dict) or self.key not in header:
            raise MapFileError(
                f"{path} is no {self.kind.name}: name another one, or begin it anew (--overwrite)"
            )
        if header[self.key] != self.version:
            raise MapFileError(
                f"{path} has format {shown_value(header[self.key])} of the {self.kind.name}, but this "
                f"program writes {self.version}: begin it anew (--overwrite)"
            )
        return header


def cut(path: Path) -> None:
    """Cut off what a killed run left half-written."""
    with path.open("rb+") as file:
        file.truncate(_whole_length(file.read()))


def appended(
    path: Path, results: Iterable[Result], as_data: Callable[[Result], Mapping[str, Any]]
) -> Iterator[Result]:
    """Write results to the end of a file as they come, and yield each when it is there."""
    with path.open("ab") as file:
        for result in results:
            try:
                file.write(as_line(as_data(result)).encode())
                file.flush()
            except OSError as error:
                raise FileWriteError(f"{path} cannot be written: {error.strerror or error}") from error
            yield result
        os.fsync(file.fileno())


def as_line(data: Mapping[str, Any]) -> str:
    """Return data as a line of JSON."""
    return json.dumps(data, ensure_ascii=False, allow_nan=False) + "\n"


def _whole_length(content: bytes) -> int:
    return content.rfind(b"\n") + 1


def _whole_lines(path: Path) -> list[bytes]:
    if is_stream(path) or is_standard_output(path):  # some never end
        raise MapFileError(f"{path} is a stream, from which nothing can go on: name a file")
    try:
        content = path.read_bytes()
    except OSError as error:
        raise MapFileError(f"{path} cannot be read: {error.strerror or error}") from error
    return content[: _whole_length(content)].splitlines()
