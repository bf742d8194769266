"""Looks at a site that was built: nothing in it may be loaded from elsewhere."""

import re
from collections.abc import Iterator
from pathlib import Path

_LOADED = re.compile(
    r"""<(?:script|img|iframe|source|audio|video)\b[^>]*?\bsrc=["']?(?P<src>(?:https?:)?//[^"'\s>]+)"""
    r"""|<link\b[^>]*?\bhref=["']?(?P<href>(?:https?:)?//[^"'\s>]+)"""
)
_LOADED_BY_STYLE = re.compile(r"""(?:url\(\s*|@import\s+)["']?((?:https?:)?//[^"')\s]+)""")


def loaded_from_elsewhere(site: Path) -> Iterator[str]:
    """Yield what pages and styles of a site load from another host, with the file."""
    for path in sorted(site.rglob("*")):
        if path.suffix in {".html", ".css"}:
            text = path.read_text(encoding="utf-8")
            pages = [match["src"] or match["href"] for match in _LOADED.finditer(text)]
            for address in [*pages, *_LOADED_BY_STYLE.findall(text)]:
                yield f"{path.relative_to(site).as_posix()}: {address}"
