"""Where in the file of a mechanism that stands which only its motion shows to be wrong."""

from argparse import Namespace
from pathlib import Path

from trimmer.errors import TrimmerError
from trimmer.files import STANDARD_INPUT


def located(error: TrimmerError, arguments: Namespace) -> str:
    """Return what to say of an error: file and line before its message, if it has a place in a file."""
    file = getattr(arguments, "against", None) or getattr(arguments, "file", None)
    if not error.place or not isinstance(file, Path) or getattr(arguments, "state", None):
        return str(error)
    from trimmer.mechanism.place_text import parse_place, split_assignment
    from trimmer.mechanism.problems import line_of
    from trimmer.mechanism.reading import text_of_file
    from trimmer.mechanism.toml_lines import lines_of_keys

    for text in getattr(arguments, "set", None) or ():
        if parse_place(split_assignment(text)[0])[: len(error.place)] == error.place:
            return f"--set {text}: {error}"
    line = 0 if file == STANDARD_INPUT else line_of(error.place, lines_of_keys(text_of_file(file)))
    return f"{file}: line {line}: {error}" if line else f"{file}: {error}"
