import html
import re
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from report.pages import escaping
from report.pages.environment import MarkdownEnvironment
from report.pages.pandoc import PandocError, read, write
from tests.report.pages.conversion import converted
from tests.report.rendering.sample_formulas import SPECIAL

PRINTABLE = st.text(st.characters(min_codepoint=32, max_codepoint=126), min_size=1, max_size=60)


def text_of(markdown: str) -> str:
    """Return the text that pandoc shows for Markdown in a paragraph."""
    page = converted(f"start {markdown} end", "html5", "--mathml")
    paragraph = re.fullmatch(r"<p>start (.*) end</p>\n", page, re.DOTALL)
    assert paragraph is not None, page
    return html.unescape(paragraph[1])


@settings(max_examples=25, deadline=None)
@example(SPECIAL)
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
def test_mathematics_that_would_end_early_is_refused_and_what_is_escaped_allowed(
    latex: str, reason: str
) -> None:
    with pytest.raises(ValueError, match=reason):
        escaping.display_mathematics(latex)
    assert escaping.inline_mathematics(r"\{ x \$") == r"$\{ x \$$"


def test_an_attribute_keeps_quotes_and_backslashes() -> None:
    page = converted(f"[x]{{label={escaping.attribute(SPECIAL)}}}", "html5")
    value = re.search(r'data-label="([^"]*)"', page)
    assert html.unescape(value[1]) == SPECIAL


@settings(deadline=None)
@given(st.text(max_size=20), st.text(max_size=20))
def test_what_is_added_to_markdown_is_escaped_and_markdown_is_not(text: str, other: str) -> None:
    bold = escaping.markdown("**{}**", text)
    assert bold == f"**{escaping.escaped(text)}**"
    shown = escaping.escaped(other)
    assert bold + other == f"{bold}{shown}"
    assert other + bold == f"{shown}{bold}"
    assert escaping.Markdown("*").join([bold, other]) == f"{bold}*{shown}"
    assert escaping.markdown("{a} {b:.1f} {}", bold, a=other, b=2.25) == f"{shown} 2\\.2 {bold}"
    assert escaping.escaped(bold) == escaping.plain(bold) == bold
    made = (bold + other, other + bold, escaping.markdown("{}", text), shown)
    assert all(isinstance(each, escaping.Markdown) for each in made)


@settings(deadline=None)
@given(st.text(max_size=20))
def test_a_template_escapes_all_that_is_not_markdown_by_its_type(text: str) -> None:
    environment = MarkdownEnvironment()

    def rendered(template: str) -> str:
        return environment.from_string(template).render(text=text, bold=escaping.markdown("**{}**", text))

    shown = escaping.escaped(text)
    assert rendered("{{ text }}") == rendered('{{ text ~ "" }}') == shown
    assert rendered("{{ bold }}") == f"**{shown}**"
    assert rendered('{{ bold ~ "*" ~ text }}') == rf"**{shown}**\*{shown}"
    assert rendered('{{ [text, bold] | join("; ") }}') == rf"{shown}\; **{shown}**"
    assert rendered("{% macro m(x) %}*{{ x }}*{% endmacro %}{{ m(text) }}") == f"*{shown}*"
    macro = "{% macro m(x) %}*{{ x }}*{% endmacro %}"
    assert rendered(macro + "{{ m(text) ~ text }}{{ m(m(text)) }}") == f"*{shown}*{shown}**{shown}**"
    assert rendered("{% set x %}*{{ text }}*{% endset %}{{ x ~ text }}") == f"*{shown}*{shown}"
    assert rendered("{{ bold | lower }}") == escaping.escaped(f"**{shown}**".lower())


def test_no_name_of_a_place_holds_markup() -> None:
    assert escaping.identifier("eq-2.8") == "eq-2.8"
    for text in ("", "a b", "a}", "a)", "a#", 'a"', "ä"):
        with pytest.raises(ValueError, match="names no place"):
            escaping.identifier(text)


@pytest.mark.parametrize("character", ["\n", "\u2028", "\u202e", "\x1b", "\x00", "\ud800", "\u200b"])
def test_what_is_not_seen_cannot_begin_a_line_or_turn_it(character: str) -> None:
    shown = escaping.escaped(f"a{character}# b")
    assert shown == (r"a\?\# b" if character == "\ud800" else r"a \# b")


def test_pandoc_reads_no_file_that_the_text_names(tmp_path: Path) -> None:
    (tmp_path / "secret.csv").write_text("secret")
    with pytest.raises(PandocError):
        write(read(f"![a]({tmp_path}/secret.csv)"), "html5", ["--embed-resources", "--standalone"])
