"""Files that commands read and write: their names, what may be replaced, and what goes to standard output."""

import os
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Mapping
from itertools import combinations
from pathlib import Path

from trimmer.command_line.parser import OptionError, as_option
from trimmer.files import (
    PDF,
    PNG,
    STANDARD_INPUT,
    SVG,
    FileKind,
    FileWriteError,
    check_target,
    is_standard_output,
    is_stream,
)
from trimmer.messages import printable, shown_value
from trimmer.progress import is_silenced

PICTURES = {".svg": SVG, ".png": PNG, ".pdf": PDF}  # Kinds of pictures by the end of the file's name

Kinds = Mapping[str, FileKind]
"""Kinds that an option can write, by the end of the file's name; the end "" stands for any name."""


def file_to_read(text: str) -> Path:
    """Read the name of a file to read, as the type of an option: ``-`` is standard input, ``./-`` a file."""
    path = _named(text)
    return path.absolute() if path == STANDARD_INPUT and text != str(STANDARD_INPUT) else path


def file_to_write(text: str) -> Path:
    """Read the name of a file to write, as the type of an option; ``-`` is refused, since it is no file."""
    if text == str(STANDARD_INPUT):
        raise ArgumentTypeError("'-' is no file; write /dev/stdout for standard output, or ./- for a file")
    return _named(text)


def folder_to_read(text: str) -> Path:
    """Read the name of a folder to read, as the type of an option; ``-`` is a folder of that name."""
    return _named(text)


def folder_to_write(text: str) -> Path:
    """Read the name of a folder to write into, as the type of an option."""
    return _named(text)


def _named(text: str) -> Path:
    """Return the path of a name; one of several lines could make a message say what it does not."""
    if "\n" in text:
        raise ArgumentTypeError(f"{shown_value(text)} has a line end in it; give it another name")
    return Path(text)


def add_input(parser: ArgumentParser, name: str, meaning: str, *, optional: bool = False) -> None:
    """Add a file to read, by position, where it may be optional, or as an option."""
    settings = {"nargs": "?"} if optional else {}
    parser.add_argument(name, type=file_to_read, metavar="FILE", help=meaning, **settings)  # type: ignore[arg-type]


def add_overwrite_option(parser: ArgumentParser) -> None:
    """Add the option that lets files of any kind be replaced."""
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace files even if they are of another kind than what is written",
    )


def check_targets(arguments: Namespace, targets: Mapping[str, Kinds], sources: Mapping[str, str]) -> None:
    """Check names of files to write, and against those that are read, before any work is done."""
    chosen = {
        name: Path(getattr(arguments, name)) for name in targets if getattr(arguments, name) is not None
    }
    if arguments.overwrite and not chosen:
        raise OptionError(f"--overwrite has no effect without {' or '.join(map(as_option, targets))}")
    kinds = {name: _kind(name, path, targets[name]) for name, path in chosen.items()}
    for name, path in chosen.items():
        for source, meaning in sources.items():
            read = getattr(arguments, source)
            if read is not None and read != STANDARD_INPUT and _same(path, read):
                raise OptionError(f"{as_option(name)} {path}: is {meaning}; name another one to write")
    for (name, path), (other, second) in combinations(chosen.items(), 2):
        if _same(path, second) and not _swallows(path):
            raise OptionError(f"{as_option(name)} and {as_option(other)} both write {path}: name two files")
    for name, path in chosen.items():
        check_target(path, kinds[name], overwrite=arguments.overwrite)


def keep(path: Path) -> None:
    """Refuse a file to write that is there already, unless it is empty or standard output."""
    if os.path.islink(path) and not os.path.exists(path):
        raise FileWriteError(
            f"{path} is a symbolic link to {os.readlink(path)}, which leads to no file: name another "
            "file, or remove the link first"
        )
    if not is_standard_output(path) and _holds_something(path):
        raise FileWriteError(f"{path} is there already: name another file, or remove it first")


def show(text: str, *written: Path | None) -> None:
    """Print what a command has to tell.

    If standard output takes one of its files, it goes to standard error, or with ``--quiet`` nowhere.
    """
    taken = any(path is not None and is_standard_output(path) for path in written)
    if not (taken and is_silenced()):
        print(printable(text), file=sys.stderr if taken else sys.stdout)


def _kind(name: str, path: Path, kinds: Kinds) -> FileKind:
    kind = kinds.get(path.suffix.lower(), kinds.get(""))
    if kind is None and len(kinds) == 1 and (is_stream(path) or is_standard_output(path)):
        (kind,) = kinds.values()
    if kind is None:
        raise OptionError(f"{as_option(name)} {path}: the name must end in {', '.join(kinds)}")
    return kind


def _holds_something(path: Path) -> bool:
    try:
        return path.is_file() and path.stat().st_size > 0
    except OSError:  # writing says why
        return False


def _same(path: Path, other: Path) -> bool:
    try:
        return os.path.samefile(path, other)
    except OSError:
        return os.path.realpath(path) == os.path.realpath(other)


def _swallows(path: Path) -> bool:
    """Say whether what is written there is lost anyway."""
    return _same(path, Path(os.devnull))
