import re

import pytest

from report.pages.formulas.mathml import repaired
from tests.report.pages.conversion import converted


def mathml(latex: str) -> str:
    return repaired(converted(f"$${latex}$$", "html5", "--mathml"))


@pytest.mark.parametrize(
    ("latex", "mark"),
    [
        (r"\dot{q}", "\u02d9"),
        (r"\ddot{q}", "\u00a8"),
        (r"\hat{u}", "\u02c6"),
        (r"\tilde{u}", "\u02dc"),
        (r"\bar{u}", "\u00af"),
    ],
)
def test_an_accent_is_a_spacing_character_that_does_not_stretch(latex: str, mark: str) -> None:
    assert f'<mo stretchy="false">{mark}</mo>' in mathml(latex)
    assert '<mover accent="true">' in mathml(latex)
    assert 'stretchy="false"' not in mathml(r"\widehat{ab}")


@pytest.mark.parametrize(
    ("content", "stretch"),
    [
        *((each, "false") for each in (r"q_{1} - q_{2}", r"\dot{q}_{1} + x^{2}", r"\omega t")),
        *((each, "true") for each in (r"\frac{a}{b}", r"\sqrt{x}", r"\begin{matrix}1\\2\end{matrix}")),
    ],
)
def test_brackets_stretch_around_tall_content_and_no_other(content: str, stretch: str) -> None:
    assert re.findall(r'stretchy="(\w+)"[^>]*>[()]', mathml(rf"\left({content}\right)")) == [stretch] * 2


@pytest.mark.parametrize(
    ("latex", "spaces"),
    [
        (r"A \sin{\left(x \right)}", 1),
        (r"\sin{\left(x \right)}", 0),
        (r"a + \sin{\left(x \right)}", 0),
        (r"\sin x", 1),
        (r"f{\left(x \right)} \cos^{2}{\left(x \right)}", 1),
    ],
)
def test_a_function_keeps_a_thin_space(latex: str, spaces: int) -> None:
    assert mathml(latex).count("<mspace") == spaces


def test_cells_are_aligned_by_the_style_sheet_alone() -> None:
    page = mathml(r"\left[\begin{matrix}1 & 2\end{matrix}\right]")
    assert page.count('<mtd columnalign="center">') == 2
    assert "text-align" not in page


def test_aligned_lines_have_fractions_of_full_size_and_the_latex_stays() -> None:
    page = mathml(r"\begin{aligned} a & = \frac{1}{2} \\ & < b \end{aligned}")
    assert '<mtable displaystyle="true" class="aligned">' in page
    assert re.search(r'<annotation encoding="application/x-tex">\\begin\{aligned\} .* &amp; &lt; b', page)
