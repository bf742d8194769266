"""What stands between paragraphs of Markdown: a formula, lines of code."""

import re

from report.pages import escaping
from report.pages.escaping import Markdown
from report.pages.formulas.line_breaking import fit


def formula(latex: str, name: str, line: float) -> Markdown:
    """Return a displayed formula, broken to fit the line, in a Div that carries its name."""
    broken = escaping.display_mathematics(fit(escaping.checked(latex), line))
    return Markdown(f"::: {{.formula name={escaping.attribute(name)}}}\n{broken}\n:::")


def code_block(text: str) -> Markdown:
    """Return text as a code block, fenced by more backticks than stand in it."""
    longest = max((len(run) for run in re.findall("`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return Markdown(f"{fence}\n{text.rstrip()}\n{fence}")
