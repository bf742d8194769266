"""Transcripts of the command line: calls, and all that they answer, in files that are read in a diff.

``python -m tests.trimmer.command_line.transcript [NAME ...]`` makes them anew, from the calls that they hold.
In a file of them a line ``$ ...`` is a call, and below it, with four blanks, what it prints on standard
output, with ``! `` what it prints on standard error, and with ``= `` its exit code, if that is not 0.
``# ...`` is said of what follows. ``$ trimmer ... < FILE`` reads standard input from a file, ``$ head FILE``
shows how a text begins, and of a picture panels and words, ``$ ls`` lists what was written. The calls of a
file are made in turn, in one folder; those of ``slow-*.txt`` only where slow tests are run.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from tests.complaints import complaints
from tests.trimmer.command_line.alike import alike, readable
from tests.trimmer.command_line.inputs import write_inputs
from trimmer.command_line.main import main

FOLDER = Path(__file__).parent / "transcripts"
BEGINNING = 6  # Lines that ``head`` shows


@dataclass(frozen=True)
class Call:
    """A call and its answer."""

    said: tuple[str, ...]  # Comment lines before it
    line: str  # The words as they are typed
    out: str = ""  # What is printed on standard output
    err: str = ""  # What is printed on standard error
    code: int = 0  # The exit code
    printed: str = ""  # What is printed on standard output as it is, and not in the form that is kept

    def __str__(self) -> str:
        lines = [*(f"# {each}" for each in self.said), f"$ {self.line}"]
        lines += [f"    {line}".rstrip() for line in self.out.splitlines()]
        lines += [f"! {line}" for line in self.err.splitlines()]
        return "\n".join([*lines, *([f"= {self.code}"] if self.code else [])])

    def alike(self, other: Call) -> bool:
        """Say whether two answers are the same to rounding."""
        return self.code == other.code and alike(self.out, other.out) and alike(self.err, other.err)


def read(path: Path) -> list[Call]:
    """Return the calls of a file, with their answers."""
    calls: list[Call] = []
    said: list[str] = []
    for line in path.read_text("utf-8").splitlines():
        mark, rest = line[:2], line[2:]
        if mark == "# ":
            said.append(rest)
        elif mark == "$ ":
            calls.append(Call(tuple(said), rest))
            said = []
        elif mark == "! ":
            calls[-1] = replace(calls[-1], err=f"{calls[-1].err}{rest}\n")
        elif mark == "= ":
            calls[-1] = replace(calls[-1], code=int(rest))
        elif calls:
            calls[-1] = replace(calls[-1], out=f"{calls[-1].out}\n{line[4:]}")
    return [replace(call, out=call.out.strip("\n")) for call in calls]


def written(calls: list[Call]) -> str:
    """Return the text of a file of calls."""
    return "\n\n".join(map(str, calls)) + "\n"


def made(calls: list[Call], folder: Path) -> Iterator[Call]:
    """Make calls in a folder, and yield them with what they answer now."""
    before, width = os.getcwd(), os.environ.get("COLUMNS")
    os.chdir(folder)
    os.environ["COLUMNS"] = "200"
    try:
        there = set(os.listdir())
        for call in calls:
            yield _answered(call, there)
    finally:
        os.chdir(before)
        os.environ.pop("COLUMNS")
        os.environ.update({} if width is None else {"COLUMNS": width})


def _answered(call: Call, there: set[str]) -> Call:
    line, _, source = call.line.partition(" < ")
    program, *words = shlex.split(line)
    if program == "ls":
        return Call(call.said, call.line, "\n".join(sorted(_files() - there)))
    if program == "head":
        return Call(call.said, call.line, _beginning(Path(words[0])))
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", newline="\n") for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), _standard_input(source):
        try:
            code = main(words)
        except SystemExit as ended:
            code = int(ended.code or 0)
    told, complained = (_content(stream) for stream in (out, err))
    return Call(call.said, call.line, readable(told), complaints(complained), code, told)


def _content(stream: io.TextIOWrapper) -> str:
    stream.flush()
    assert isinstance(stream.buffer, io.BytesIO)
    return stream.buffer.getvalue().decode("utf-8")


@contextlib.contextmanager
def _standard_input(source: str) -> Iterator[None]:
    before = sys.stdin
    with open(source or os.devnull, encoding="utf-8") as sys.stdin:
        try:
            yield
        finally:
            sys.stdin = before


def _files() -> set[str]:
    links = {each.name for each in Path().iterdir() if each.is_symlink()}
    return {str(each) for each in Path().rglob("*") if each.is_file() and each.parts[0] not in links}


def _beginning(path: Path) -> str:
    lines = path.read_text("utf-8").splitlines()
    if path.suffix == ".svg":
        panels, told = (re.findall(each, "\n".join(lines)) for each in (r'id="axes_\d+"', "<!-- (.*?) -->"))
        words = [each for each in dict.fromkeys(told) if re.search(r"(?<!\\)\b[^\W\d_]{2}", each)]
        return "\n".join([f"{len(panels)} panels", *words])
    more = [f"... {len(lines)} lines"] if len(lines) > BEGINNING else []
    return "\n".join([*lines[:BEGINNING], *more])


def renew(path: Path) -> None:
    """Make the calls of a file anew, and write what they answer."""
    with tempfile.TemporaryDirectory() as folder:
        write_inputs(Path(folder))
        path.write_text(written(list(made(read(path), Path(folder)))), "utf-8")
    shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    for name in sys.argv[1:] or sorted(each.stem for each in FOLDER.glob("*.txt")):
        renew(FOLDER / f"{name}.txt")
