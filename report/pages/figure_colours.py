"""Colours of figures that follow the page's: each becomes a variable that has another value in the dark.

The drawings themselves stay as they are drawn, in light colours, for the PDF.
"""

import re
from collections.abc import Iterable
from itertools import pairwise
from typing import Final

GROUND: Final = 0.21
"""OKLab lightness of the dark page, which white becomes."""
TEXT: Final = 0.92  # OKLab lightness of text on it, which black becomes
LIFTED: Final = 0.6  # Exponent by which colours that are no greys are made lighter than their mirror image
GREY: Final = 0.02  # OKLab chroma below which a colour counts as grey
_COLOUR: Final = re.compile(r"((?:fill|stroke): ?)#([0-9a-f]{6})\b")
_TO_CONE: Final = (
    (0.4122214708, 0.5363325363, 0.0514459929),
    (0.2119034982, 0.6806995451, 0.1073969566),
    (0.0883024619, 0.2817188376, 0.6299787005),
)
_TO_LAB: Final = (
    (0.2104542553, 0.7936177850, -0.0040720468),
    (1.9779984951, -2.4285922050, 0.4505937099),
    (0.0259040371, 0.7827717662, -0.8086757660),
)
_FROM_LAB: Final = (
    (1.0, 0.3963377774, 0.2158037573),
    (1.0, -0.1055613458, -0.0638541728),
    (1.0, -0.0894841775, -1.2914855480),
)
_FROM_CONE: Final = (
    (4.0767416621, -3.3077115913, 0.2309699292),
    (-1.2684380046, 2.6097574011, -0.3413193965),
    (-0.0041960863, -0.7034186147, 1.7076147010),
)
"""Matrices of OKLab (Ottosson, "A perceptual color space for image processing", 2020)."""
Triple = tuple[float, float, float]


def with_variables(svg: str) -> str:
    """Return a drawing whose colours are the variables of ``variables``."""
    return _COLOUR.sub(r"\1var(--c\2)", svg)


def variables(drawings: Iterable[str]) -> str:
    """Return CSS that gives each colour of drawings its value in the light and in the dark."""
    used = sorted({"000000", "ffffff"} | {colour for svg in drawings for _, colour in _COLOUR.findall(svg)})
    return "\n".join((":root {", *(f"  --c{c}: light-dark(#{c}, {in_the_dark(c)});" for c in used), "}"))


def in_the_dark(colour: str) -> str:
    """Return #rrggbb with the same hue and the opposite lightness; the colour is given without #."""
    lightness, *chroma = _lab(colour)
    is_grey = sum(each**2 for each in chroma) < GREY**2
    lifted = (1 - min(lightness, 1.0)) ** (1.0 if is_grey else LIFTED)
    turned = GROUND + (TEXT - GROUND) * lifted
    for share in (1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.0):
        linear = _linear((turned, share * chroma[0], share * chroma[1]))
        if all(-1e-4 <= each <= 1.0001 for each in linear):
            break
    return "#" + "".join(f"{round(255 * _encoded(min(max(each, 0.0), 1.0))):02x}" for each in linear)


def contrast(one: str, other: str) -> float:
    """Return the contrast of two colours, #rrggbb, as WCAG 2 defines it."""
    lights = sorted(
        0.2126 * red + 0.7152 * green + 0.0722 * blue
        for red, green, blue in (_decoded(colour.removeprefix("#")) for colour in (one, other))
    )
    ((darker, lighter),) = pairwise(lights)
    return (lighter + 0.05) / (darker + 0.05)


def _lab(colour: str) -> Triple:
    return _times(_TO_LAB, _cubic_root(_times(_TO_CONE, _decoded(colour))))


def _linear(lab: Triple) -> Triple:
    long, medium, short = _times(_FROM_LAB, lab)
    return _times(_FROM_CONE, (long**3, medium**3, short**3))


def _cubic_root(cone: Triple) -> Triple:
    long, medium, short = cone
    return long ** (1 / 3), medium ** (1 / 3), short ** (1 / 3)


def _times(matrix: tuple[Triple, Triple, Triple], vector: Triple) -> Triple:
    first, second, third = (sum(a * b for a, b in zip(row, vector, strict=True)) for row in matrix)
    return first, second, third


def _decoded(colour: str) -> Triple:
    """Return red, green and blue of an sRGB colour as linear light."""
    values = (int(colour[place : place + 2], 16) / 255 for place in (0, 2, 4))
    red, green, blue = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values)
    return red, green, blue


def _encoded(linear: float) -> float:
    return float(12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)
