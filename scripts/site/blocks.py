"""The code blocks of a page: what is to be run, what is a file, and what should be printed.

- ``python`` and ``sh`` blocks are run in their order, all of a page in one folder; Python blocks share names.
- The next ``text`` block holds what such a block prints; ``...`` in it stands for anything.
- A block with a title, as in ``toml title="saw.toml"``, is first written to that file.
- A comment before a block says what is special about it: ``<!-- slow -->``, ``<!-- exit 2 -->``, or
  ``<!-- not run: reason -->``.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

_BLOCK = re.compile(
    r"(?:^<!-- (?P<comment>[^\n]*) -->\n)?"
    r'^```(?P<language>\w*)(?: title="(?P<title>[^"\n]*)")?[^\n]*\n(?P<content>.*?)^```$',
    re.MULTILINE | re.DOTALL,
)
_RUN = ("python", "sh")
_OUTPUT = "text"


@dataclass(frozen=True)
class Block:
    """A block of a page."""

    language: str  # The word behind the fence
    content: str  # Its lines
    line: int  # Number of its first line in the page
    title: str | None  # Name of the file that it is, if it has one
    comment: str  # What stands in the comment before it
    output: str | None = None  # What it should print, None if the page does not say

    @property
    def is_run(self) -> bool:
        """Whether it is run."""
        return self.language in _RUN and not self.comment.startswith("not run: ")

    @property
    def slow(self) -> bool:
        """Whether it takes long."""
        return self.comment == "slow"

    @property
    def exit_code(self) -> int:
        """Exit code of its last command."""
        return int(self.comment.removeprefix("exit ")) if self.comment.startswith("exit ") else 0


def blocks(page: str) -> list[Block]:
    """Return the blocks of a page, those that print with their output."""
    found: list[Block] = []
    for block in _written(page):
        if block.language == _OUTPUT and block.title is None and found and found[-1].language in _RUN:
            found[-1] = replace(found[-1], output=block.content)
        else:
            found.append(block)
    return found


def with_outputs(page: str, printed: dict[int, str]) -> str:
    """Return a page in which what blocks print is replaced, by the line of the block."""
    last = 0

    def again(match: re.Match[str]) -> str:
        nonlocal last
        block = _block(match, page)
        text, last = (printed.get(last), 0) if block.language == _OUTPUT else (None, block.line)
        return match.group() if text is None else f"```text\n{text}```"

    return _BLOCK.sub(again, page)


def _written(page: str) -> Iterator[Block]:
    return (_block(match, page) for match in _BLOCK.finditer(page))


def _block(match: re.Match[str], page: str) -> Block:
    line = page.count("\n", 0, match.start("content")) + 1
    return Block(match["language"], match["content"], line, match["title"], match["comment"] or "")
