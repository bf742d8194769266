"""Figures in the dark: what was dark is light, hues stay, and lines can be seen."""

import colorsys

import pytest

from report.pages.drawing.style import LINES
from report.pages.figure_colours import contrast, in_the_dark, variables, with_variables

GROUND = in_the_dark("ffffff")
COLOURS = [line["color"].removeprefix("#") for line in LINES]


def hue(colour: str) -> float:
    red, green, blue = (int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5))
    return 360 * colorsys.rgb_to_hsv(red, green, blue)[0]


def test_contrast_is_that_of_wcag() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)  # an often quoted pair


def test_text_and_every_line_stand_out_from_the_dark() -> None:
    assert contrast(in_the_dark("000000"), GROUND) > 7
    assert min(contrast(in_the_dark(colour), GROUND) for colour in COLOURS) > 3


def test_a_grid_stays_faint() -> None:
    assert 1.1 < contrast(in_the_dark("d9d9d9"), GROUND) < 1.5


@pytest.mark.parametrize("colour", COLOURS[:-1])
def test_hues_stay(colour: str) -> None:
    difference = abs(hue(in_the_dark(colour)) - hue(f"#{colour}"))
    assert min(difference, 360 - difference) < 12


def test_each_colour_of_a_drawing_is_a_variable_with_two_values() -> None:
    svg = '<path style="fill: none; stroke: #0072b2; stroke-width: 1.4"/><path style="fill: #d6e6f2"/>'
    drawn, style = with_variables(svg), variables([svg])
    assert "stroke: var(--c0072b2); stroke-width" in drawn
    assert "fill: var(--cd6e6f2)" in drawn
    assert "#" not in drawn
    assert f"--c0072b2: light-dark(#0072b2, {in_the_dark('0072b2')});" in style
    assert "--cffffff: " in style
