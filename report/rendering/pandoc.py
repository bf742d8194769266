"""Calling the pandoc that comes with ``pypandoc-binary``."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

READER = (
    "markdown-raw_html-raw_tex-raw_attribute-native_divs-native_spans"
    "-citations-example_lists-implicit_figures-auto_identifiers"
)
"""Markdown in which text never acts as HTML, TeX, a citation or an example number."""


WORKERS = 2
"""How many pandocs work on a text at the same time; the text is the same with any number."""


class PandocError(RuntimeError):
    """Pandoc refused the report, or warned about it."""


def read(parts: Sequence[str]) -> tuple[bytes, ...]:
    """Read Markdown, once for all outputs; return it in pandoc's own form, in pieces.

    Args:
        parts: pieces of the text that follow each other; each stands alone.

    Raises:
        PandocError: if pandoc fails or warns.
    """
    return _all(["--from", READER, "--to", "json"], [part.encode() for part in _shared_out(parts)])


def write(content: Sequence[bytes], target: str, arguments: Sequence[str]) -> str:
    """Write what ``read`` has read in another format.

    Args:
        content: the pieces of the text, in pandoc's own form.
        target: name of pandoc's writer.
        arguments: further options of pandoc.

    Raises:
        PandocError: if pandoc fails or warns, for instance about mathematics that it cannot read.
    """
    written = _all(["--from", "json", "--to", target, "--wrap=none", *arguments], content)
    return "".join(piece.decode() for piece in written)


def _shared_out(parts: Sequence[str]) -> tuple[str, ...]:
    """Join neighbouring parts until there are as many as ``WORKERS``, of about the same length."""
    share = sum(map(len, parts)) / WORKERS
    shared: list[list[str]] = [[] for _ in range(WORKERS)]
    length = 0
    for part in parts:
        shared[min(int((length + len(part) / 2) / share), WORKERS - 1)].append(part)
        length += len(part)
    return tuple("\n\n".join(some) for some in shared if some)


def _all(arguments: Sequence[str], contents: Sequence[bytes]) -> tuple[bytes, ...]:
    with ThreadPoolExecutor() as pool:
        return tuple(pool.map(lambda content: _run(content, arguments), contents))


def _run(content: bytes, arguments: Sequence[str]) -> bytes:
    import pypandoc  # here, so that importing the package does not look for the binary

    command = [pypandoc.get_pandoc_path(), "--fail-if-warnings", *arguments]
    finished = subprocess.run(command, input=content, capture_output=True, check=False)
    if finished.returncode:
        raise PandocError(f"pandoc stopped: {finished.stderr.decode().strip()}")
    return finished.stdout
