"""Pandoc on a piece of Markdown, as the report uses it."""

from report.pages.pandoc import read, write


def converted(markdown: str, target: str, *arguments: str) -> str:
    """Return Markdown written in another format."""
    return write(read(markdown), target, arguments)
