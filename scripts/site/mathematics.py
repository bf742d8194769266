"""Formulas of a page as MathML, which browsers show without any script."""

import html
import re

from report.pages.formulas.foreign_mathematics import to_mathml

_FORMULA = re.compile(
    r'<(?P<tag>span|div) class="arithmatex">(?:\\\((?P<inline>.*?)\\\)|\\\[(?P<display>.*?)\\\])</(?P=tag)>',
    re.DOTALL,
)


class FormulaError(ValueError):
    """A formula that cannot be read."""


def with_mathml(page: str) -> str:
    """Return HTML with each formula of ``pymdownx.arithmatex`` as MathML.

    Raises:
        FormulaError: if pandoc cannot read one; it is named.
    """
    found = [_latex(match) for match in _FORMULA.finditer(page)]
    if not found:
        return page
    written = dict(zip(found, to_mathml(found), strict=True))
    return _FORMULA.sub(lambda match: _placed(match, written[_latex(match)]), page)


def _latex(match: re.Match[str]) -> str:
    return html.unescape(match["inline"] or match["display"]).strip()


def _placed(match: re.Match[str], mathml: str | None) -> str:
    if mathml is None:
        raise FormulaError(f"pandoc cannot read the formula {_latex(match)!r}")
    if match["inline"] is not None:
        return mathml.replace(' display="block"', ' display="inline"', 1)
    return f'<div class="formula">{mathml}</div>'
