"""Blocks of output in a page: told apart from code, and sentences wrapped where tables are not."""

import re

SHORT = 70
"""Characters of a line that needs no wrapping."""
_PLAIN = re.compile(r'<div class="highlight">(<pre><span></span><code>)([^<]*)(</code></pre></div>)')


def with_wrapped_sentences(page: str) -> str:
    """Return HTML in which blocks without a language have the class ``output`` and wrap their sentences."""
    return _PLAIN.sub(
        lambda match: f'<div class="highlight output">{match[1]}{_wrapped(match[2])}{match[3]}', page
    )


def _wrapped(text: str) -> str:
    return "\n".join(
        f'<span class="sentence">{line}</span>' if _is_sentence(line) else line for line in text.split("\n")
    )


def _is_sentence(line: str) -> bool:
    """Say whether a line is long and has no columns."""
    return len(line) > SHORT and "  " not in line.strip()
