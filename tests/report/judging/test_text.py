"""Prose with numbers: what is filled in, and what is refused."""

import pytest
import sympy

from report.judging.text import TextError, filled


@pytest.mark.parametrize(
    ("prose", "shown"),
    [
        ("[[ value | f2 ]] Hz", "-1234.50 Hz"),
        ("[[ value | signed1 ]]", "-1234.5"),
        ("[[ value | e3 ]]", "-1.234e+03"),
        ("[[ value | g ]] and [[ value | g2 ]]", "-1234.5 and -1.2e+03"),
        ("[[ value | percent0 ]]", "-123450%"),
        ("[[ value | power2 ]]", "$-1.23\\times10^{3}$"),
        ("[[ value ]]", "-1234.5"),
    ],
)
def test_a_number_is_written_as_its_filter_says(prose, shown):
    assert filled(prose, value=-1234.5) == shown


def test_printed_digits_and_expressions_have_filters_of_their_own():
    x = sympy.Symbol("x")
    assert filled("[[ digits | power ]]", digits="2.1e-8") == "$2.1\\times10^{-8}$"
    assert filled("$[[ root | latex ]]$", root=sympy.sqrt(x)) == "$\\sqrt{x}$"


def test_a_text_block_is_one_line_and_tex_braces_stay():
    block = r"""
        With $\frac{b}{A}$ and $\{1\}$ the gain
        is [[ gain | f1 ]] at most.
        """
    assert filled(block, gain=2.0) == r"With $\frac{b}{A}$ and $\{1\}$ the gain is 2.0 at most."


def test_a_no_break_space_is_no_space_to_break_at():
    assert filled("0.1\u00a0 m") == "0.1\u00a0 m"


@pytest.mark.parametrize(
    ("prose", "numbers", "words"),
    [
        ("[[ here | f1 ]] and [[ there | f1 ]]", {"here": 1.0}, "asks for there, not given"),
        ("[[ here | f1 ]]", {"here": 1.0, "there": 2.0}, "is given there, not used"),
        ("no number", {"here": 1.0}, "is given here, not used"),
        ("[[ 100 * here | f1 ]]", {"here": 1.0}, "calculates"),
        ("[[ here.size | f1 ]]", {"here": 1.0}, "'float object' has no attribute 'size'"),
        ("[[ here | f99 ]]", {"here": 1.0}, "f99"),
        ("[[ here | f1 ", {"here": 1.0}, "cannot be filled in"),
        ("[[ here | f1 ]]", {"here": "words"}, "cannot be filled in"),
    ],
)
def test_what_a_text_and_its_numbers_lack_is_named(prose, numbers, words):
    with pytest.raises(TextError, match=words):
        filled(prose, **numbers)
