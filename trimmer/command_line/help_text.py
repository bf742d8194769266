"""How the help of a command looks: its options, then examples as they are typed, then the exit codes."""

import textwrap
from argparse import HelpFormatter

from trimmer.command_line.command import Command

EXIT_CODES = (
    "Exit codes: 0 done; 1 an error of the program itself; 2 wrong use, or a file or output that cannot be "
    "used; 3 a simulation or a check that ended before its time; 130 interrupted."
)
WIDTH = 79
_LINE = "\n"
_PARAGRAPH = "\n\n"


class HelpText(HelpFormatter):
    """Fills paragraphs; one with an indented line keeps its lines, so that examples can be copied."""

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        return _PARAGRAPH.join(
            paragraph if "\n " in paragraph else super(HelpText, self)._fill_text(paragraph, width, indent)
            for paragraph in text.split(_PARAGRAPH)
        )


def epilog(command: Command) -> str:
    """Return what stands below the options of a command."""
    if not command.examples:
        return EXIT_CODES
    lines = [line for example in command.examples for line in (_typed(example.words), _told(example.purpose))]
    return f"{_LINE.join(['Examples:', *lines])}{_PARAGRAPH}{EXIT_CODES}"


def _typed(words: str) -> str:
    """Return a line as it is typed, continued where it is long."""
    return " \\\n      ".join(
        textwrap.wrap(f"  {words}", WIDTH - 2, break_long_words=False, break_on_hyphens=False)
    )


def _told(purpose: str) -> str:
    indent = " " * 4
    return textwrap.fill(
        purpose, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False
    )
