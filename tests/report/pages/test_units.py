"""No line ends between a number and its unit: a filter sees to it for all forms."""

import pytest

from report.pages.pandoc import read, write
from report.pages.pieces import UNITS_FILTER


def plain(markdown: str) -> str:
    """Return what the filter makes of a text, with no-break spaces shown as low lines."""
    return write(read(markdown, UNITS_FILTER), "plain", []).strip().replace("\u00a0", "_")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a gap of 40 µm, at 733.6 Hz.", "a gap of 40_µm, at 733.6_Hz."),
        ("(1.5 mm)\nof 8.1 kN/m", "(1.5_mm) of 8.1_kN/m"),
        ("at most 60 m/s², or 3 m/s² rms", "at most 60_m/s², or 3_m/s² rms"),
        ("falls by −40 dB per decade", "falls by −40_dB per decade"),
        ("an impulse of 4 m s and 3 N s/m", "an impulse of 4_m_s and 3_N_s/m"),
        ("see figure 5.9 and Listing A.6", "see figure_5.9 and Listing_A.6"),
        ("[Eq. 2.8](#x), section [5.1](#y)", "Eq._2.8, section_5.1"),
        ("200π rad/s", "200π_rad/s"),
        ("b = 2·10⁻⁸ m", "b = 2·10⁻⁸_m"),
        ("bounds “a stroke of 3.1 mm”, and more", "bounds “a stroke of 3.1_mm”, and more"),
        ("a rise of 36 % in 0.3 s", "a rise of 36_% in 0.3_s"),
    ],
)
def test_what_belongs_together_stays_together(text: str, expected: str) -> None:
    assert plain(text) == expected


@pytest.mark.parametrize(
    "text", ["the 5 masses", "in 2 steps", "of 3 more", "a figure of speech", "x is 2 s’s"]
)
def test_all_else_may_break(text: str) -> None:
    assert "_" not in plain(text)


def test_a_formula_is_a_number_if_it_ends_with_one() -> None:
    assert "^{−8}_m" in plain(r"$2\times10^{-8}$ m") or "⁻⁸_m" in plain(r"$2\times10^{-8}$ m")
    assert "_" not in plain("where $x$ m is")


def test_a_line_break_in_the_source_is_a_space() -> None:
    assert plain("at 550\nHz") == "at 550_Hz"
