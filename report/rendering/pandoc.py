"""Calling the pandoc that comes with ``pypandoc-binary``."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence

READER = (
    "markdown-raw_html-raw_tex-raw_attribute-native_divs-native_spans"
    "-citations-example_lists-implicit_figures-auto_identifiers"
)
"""Markdown in which text never acts as HTML, TeX, a citation or an example number."""


class PandocError(RuntimeError):
    """Pandoc refused the report, or warned about it."""


def convert(markdown: str, target: str, arguments: Sequence[str]) -> str:
    """Convert Markdown to another format.

    Args:
        markdown: the source.
        target: name of pandoc's writer.
        arguments: further options of pandoc.

    Raises:
        PandocError: if pandoc fails or warns, for instance about mathematics that it cannot read.
    """
    import pypandoc  # here, so that importing the package does not look for the binary

    command = [pypandoc.get_pandoc_path(), "--from", READER, "--to", target, "--fail-if-warnings", *arguments]
    finished = subprocess.run(command, input=markdown.encode(), capture_output=True, check=False)
    if finished.returncode:
        raise PandocError(f"pandoc could not write {target}: {finished.stderr.decode().strip()}")
    return finished.stdout.decode()
