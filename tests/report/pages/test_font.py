"""The mathematics font that the HTML carries."""

import pytest
from fontTools.ttLib import TTFont

from report.pages.html import FONT

NEEDED = "√∫∑∂∞±×·≤≥≠≈→˙¨ˆ˜¯αβγδεζηθκλμνξπρστφχψωΓΔΘΛΞΠΣΦΨΩ𝐴𝑞𝜔𝜃ℝ⌊⌋()[]{}|−"


@pytest.fixture(scope="module")
def font() -> TTFont:
    return TTFont(FONT)


def test_the_font_has_the_characters_of_the_report(font: TTFont) -> None:
    assert [character for character in NEEDED if ord(character) not in font.getBestCmap()] == []


@pytest.mark.parametrize("character", ["√", "(", ")", "[", "]", "{"])
def test_signs_that_grow_have_their_larger_forms(font: TTFont, character: str) -> None:
    variants = font["MATH"].table.MathVariants
    glyph = font.getBestCmap()[ord(character)]
    construction = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(glyph)]
    assert construction.VariantCount > 3
    assert construction.GlyphAssembly is not None


def test_the_licence_lies_beside_the_font() -> None:
    licence = (FONT.parent / "STIX-Two-Math-LICENSE.txt").read_text(encoding="utf-8")
    assert "SIL OPEN FONT LICENSE Version 1.1" in licence
