"""Calling the pandoc that comes with ``pypandoc-binary``."""

import subprocess
from collections.abc import Sequence
from pathlib import Path

READER = (
    "markdown-raw_html-raw_tex-raw_attribute-native_divs-native_spans"
    "-citations-example_lists-implicit_figures-auto_identifiers"
)
"""Markdown in which text never acts as HTML, TeX, a citation or an example number."""


class PandocError(RuntimeError):
    """Pandoc refused the report, or warned about it."""


def read(markdown: str, lua_filter: Path | None = None) -> bytes:
    """Read Markdown, once for all outputs; return it in pandoc's own form, changed by a filter.

    Raises:
        PandocError: if pandoc fails or warns.
    """
    changed = [] if lua_filter is None else [f"--lua-filter={lua_filter}"]
    return _run(markdown.encode(), ["--from", READER, "--to", "json", *changed])


def write(content: bytes, target: str, arguments: Sequence[str]) -> str:
    """Write what ``read`` has read in another format, with further options of pandoc.

    Raises:
        PandocError: if pandoc fails or warns, for instance about mathematics that it cannot read.
    """
    return _run(content, ["--from", "json", "--to", target, "--wrap=none", *arguments]).decode()


def _run(content: bytes, arguments: Sequence[str]) -> bytes:
    import pypandoc  # here, so that importing the package does not look for the binary

    # In its sandbox pandoc reads no file that stands in the text.
    command = [pypandoc.get_pandoc_path(), "--sandbox", "--fail-if-warnings", *arguments]
    finished = subprocess.run(command, input=content, capture_output=True, check=False)
    if finished.returncode:
        raise PandocError(f"pandoc stopped: {finished.stderr.decode().strip()}")
    return finished.stdout
