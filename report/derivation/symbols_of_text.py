"""The symbols that stand in TeX mathematics: letters with their index, without accents and exponents."""

from __future__ import annotations

import re
from collections.abc import Iterator

_GREEK = (
    "alpha|beta|gamma|delta|epsilon|varepsilon|zeta|eta|theta|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|"
    "varphi|chi|psi|omega|Gamma|Delta|Theta|Lambda|Sigma|Phi|Psi|Omega|ell"
)
_WORDS = re.compile(
    r"\\(?:text|operatorname|mathrm|mathsf|mathit)\*?\{[^{}]*\}"
    r"|\\(?:begin|end)\{[^{}]*\}(?:\{[^{}]*\})?"
)
_ACCENT = re.compile(r"\\(?:dot|ddot|dddot|bar|overline|hat|tilde)(?:\{([^{}]*)\}|\s+([A-Za-z]))")
_COMMAND = re.compile(rf"\\(?!(?:{_GREEK})(?![A-Za-z]))[A-Za-z]+")
_INDEX = r"\{[^{}]*\}|[A-Za-z0-9]|\\[A-Za-z]+"
_SYMBOL = re.compile(rf"(\\(?:{_GREEK})(?![A-Za-z])|(?<![\\A-Za-z])[A-Za-z])(?:_({_INDEX}))?")
_MATHEMATICS = re.compile(r"\$([^$]+)\$")


def symbols(latex: str) -> frozenset[str]:
    """Return the symbols of a formula, such as ``q_2``; an index loses its braces."""
    plain = _WORDS.sub(" ", latex)
    while (without := _ACCENT.sub(lambda match: f" {match[1] or match[2]}", plain)) != plain:
        plain = without
    plain = _COMMAND.sub(lambda match: " " * len(match[0]), plain)
    return frozenset(
        letter + (f"_{index.strip('{}').replace(' ', '')}" if index else "")
        for letter, index in _SYMBOL.findall(plain)
    )


def formulas(prose: str) -> Iterator[str]:
    """Yield the formulas between dollar signs in Markdown prose."""
    yield from _MATHEMATICS.findall(prose)
