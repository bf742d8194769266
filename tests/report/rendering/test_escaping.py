from __future__ import annotations

import html
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from report.rendering import escaping
from tests.report.rendering.conversion import converted
from tests.report.rendering.sample_formulas import SPECIAL

PRINTABLE = st.text(st.characters(min_codepoint=32, max_codepoint=126), min_size=1, max_size=60)


def text_of(markdown: str) -> str:
    """Return the text that pandoc shows for Markdown in a paragraph."""
    page = converted(f"start {markdown} end", "html5", "--mathml")
    paragraph = re.fullmatch(r"<p>start (.*) end</p>\n", page, re.DOTALL)
    assert paragraph is not None, page
    return html.unescape(paragraph[1])


def test_special_characters_are_shown_as_they_are() -> None:
    assert text_of(escaping.plain(SPECIAL)) == SPECIAL


@settings(max_examples=25, deadline=None)
@given(PRINTABLE.filter(str.strip))
def test_plain_text_is_never_markup(text: str) -> None:
    assert text_of(escaping.plain(text)) == " ".join(text.split())


def test_mathematics_in_plain_text_is_kept_and_the_rest_escaped() -> None:
    shown = escaping.plain_with_mathematics(r"gain $q_1$ at *10* % of a_b: 5 $ and 6 $")
    assert shown == r"gain $q_1$ at \*10\* \% of a\_b\: 5 \$ and 6 \$"


@pytest.mark.parametrize(
    ("printed", "shown"),
    [
        ("-1.05e-3", r"$-1.05 \times 10^{-3}$"),
        ("488", "$488$"),
        ("3.0E+05", r"$3.0 \times 10^{5}$"),
        ("12 to 13", "12 to 13"),
        ("<1", r"\<1"),
    ],
)
def test_digits_stay_the_printed_ones(printed: str, shown: str) -> None:
    assert escaping.digits(printed) == shown


@pytest.mark.parametrize(
    ("latex", "reason"), [(" ", "empty"), ("a $ b", "dollar"), (r"\frac{1}{2", "braces"), ("{", "braces")]
)
def test_mathematics_that_would_end_early_is_refused(latex: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        escaping.display_mathematics(latex)


def test_escaped_braces_and_dollars_are_allowed() -> None:
    assert escaping.inline_mathematics(r"\{ x \$") == r"$\{ x \$$"


def test_an_attribute_keeps_quotes_and_backslashes() -> None:
    page = converted(f"[x]{{label={escaping.attribute(SPECIAL)}}}", "html5")
    value = re.search(r'data-label="([^"]*)"', page)
    assert value is not None
    assert html.unescape(value[1]) == SPECIAL
