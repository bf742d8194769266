"""Where in the file of a mechanism, or in an option, that stands which only later shows to be wrong."""

from argparse import Namespace
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from trimmer.errors import TrimmerError
from trimmer.files import STANDARD_INPUT


def located(error: TrimmerError, arguments: Namespace) -> str:
    """Return what to say of an error: option, or file and line, first, if it has a place there."""
    if not error.place:
        return str(error)
    return f"{_option(error.place, arguments) or _file(error.place, arguments)}{error}"


def _option(place: tuple[str, ...], arguments: Namespace) -> str:
    from trimmer.mechanism.place_text import parse_place, split_assignment

    for option, text in _given(arguments):
        with suppress(TrimmerError):
            if parse_place(split_assignment(f"{text}=")[0])[: max(len(place), 2)] == place:
                return f"{option}: "
    return ""


def _given(arguments: Namespace) -> Iterator[tuple[str, str]]:
    """Return each option that names a place, as it was written, and the text that begins with the place."""
    given = vars(arguments)
    interval = given.get("vary") or ()
    if isinstance(interval, str):
        yield f"--vary {interval} --from {arguments.start} --to {arguments.stop}", interval
        interval = ()
    for option, texts in (("vary", interval), ("free", given.get("free")), ("set", given.get("set"))):
        yield from ((f"--{option} {text}", text) for text in texts or ())


def _file(place: tuple[str, ...], arguments: Namespace) -> str:
    file = getattr(arguments, "against", None) or getattr(arguments, "file", None)
    if not isinstance(file, Path) or getattr(arguments, "state", None):
        return ""
    from trimmer.mechanism.problems import line_of
    from trimmer.mechanism.reading import text_of_file
    from trimmer.mechanism.toml_lines import lines_of_keys

    line = 0 if file == STANDARD_INPUT else line_of(place, lines_of_keys(text_of_file(file)))
    return f"{file}: line {line}: " if line else f"{file}: "
