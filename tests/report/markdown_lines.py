"""Markdown of a report as a text to keep: a line for each paragraph and table, without escapes."""

import re
from collections.abc import Mapping


def markdown_lines(pages: Mapping[str, str], without: str = "") -> str:
    """Return the pages below their names, without one of them."""
    text = "\n".join(f"# {name}\n{page}" for name, page in pages.items() if name != without)
    text = re.sub(r"\n::::?(?: (?:row|cell))?(?=\n)", " |", re.sub(r"\\(?=[^\w\s])", "", text))
    return re.sub(r"(?:[ |]*\n)+", "\n", re.sub(r"(?:[ |]*\|)\n(?=\S)", " | ", text)).strip() + "\n"
