"""A waveform as a small SVG: text stays text, and the page gives the colours."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final
from xml.sax.saxutils import escape

import numpy as np

from trimmer.arrays import Reals

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 480, 168, 34, 8, 130, 34
ROOM: Final = 1.12  # Height of half of the plane over the largest value in it
ROUNDING: Final = 1e-9
COLOURS: Final = {"input": "#555555", "output": "#0072b2", "harmonic": "#d55e00"}
DASHES: Final = {"input": "3 3", "output": "none", "harmonic": "8 3"}
NAMES: Final = {"input": "input", "output": "output y", "harmonic": "first harmonic"}


@dataclass(frozen=True, eq=False)
class WaveformPiece:
    """A piece of a waveform: phases, rad, and the output there over A or the level, shape (n,) each."""

    phases: Reals
    output: Reals


def first_harmonic(pieces: tuple[WaveformPiece, ...], phases: Reals) -> Reals:
    """Return the first harmonic of a waveform at phases, rad."""
    cosine, sine = (
        sum(float(np.trapezoid(piece.output * each(piece.phases), piece.phases)) for piece in pieces) / np.pi
        for each in (np.cos, np.sin)
    )
    return np.asarray(cosine * np.cos(phases) + sine * np.sin(phases))


def waveform_svg(identifier: str, title: str, words: str, pieces: tuple[WaveformPiece, ...]) -> str:
    """Return a drawing of one period: the input, the output in its pieces, and its first harmonic.

    Its ids begin with the identifier; the words are for a reader who does not see it.
    """
    first, last = float(pieces[0].phases[0]), float(pieces[-1].phases[-1])
    phases = np.linspace(first, last, 97)
    highest = ROOM * max(1.0, *(float(abs(piece.output).max()) for piece in pieces))
    plane = _Plane(first, last, highest)
    curves = {
        "input": [(phases, np.sin(phases))],
        "harmonic": [(phases, first_harmonic(pieces, phases))],
        "output": [(piece.phases, piece.output) for piece in pieces],
    }
    return "".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="waveform" role="img" '
            f'viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
            f'font-family="Libertinus Serif" font-size="11" '
            f'aria-labelledby="{identifier}-title {identifier}-description">',
            f'<title id="{identifier}-title">{escape(title)}</title>',
            f'<desc id="{identifier}-description">{escape(words)}</desc>',
            *_axes(plane),
            *(_upright(plane, float(piece.phases[0])) for piece in pieces[1:]),
            *(plane.curve(name, *each) for name, parts in curves.items() for each in parts),
            *_legend(),
            "</svg>",
        )
    )


@dataclass(frozen=True)
class _Plane:
    """Where phases and outputs lie in the drawing; ``highest`` is at its upper edge."""

    first: float
    last: float
    highest: float

    def across(self, phase: float) -> float:
        return LEFT + (phase - self.first) / (self.last - self.first) * (WIDTH - LEFT - RIGHT)

    def down(self, output: float) -> float:
        return TOP + (self.highest - output) / (2 * self.highest) * (HEIGHT - TOP - BOTTOM)

    def curve(self, name: str, phases: Reals, output: Reals) -> str:
        places = zip(phases, output, strict=True)
        points = " ".join(f"{self.across(phase):.1f},{self.down(value):.1f}" for phase, value in places)
        width = 2.2 if name == "output" else 1.3
        return (
            f'<polyline class="{name}" points="{points}" fill="none" stroke="{COLOURS[name]}" '
            f'stroke-width="{width}" stroke-dasharray="{DASHES[name]}"/>'
        )


def _axes(plane: _Plane) -> Iterator[str]:
    base, right = HEIGHT - BOTTOM, WIDTH - RIGHT
    for value, number in ((-1, "−1"), (0, "0"), (1, "1")):
        level = plane.down(value)
        yield (
            f'<path class="rule" d="M{LEFT},{level:.1f}H{right}" stroke="#cccccc" stroke-width="0.6"/>'
            f'<text x="{LEFT - 6}" y="{level + 4:.1f}" text-anchor="end">{number}</text>'
        )
    first, last = (2 * phase / math.pi for phase in (plane.first, plane.last))
    for quarter in range(math.ceil(first - ROUNDING), math.floor(last + ROUNDING) + 1):
        place = plane.across(quarter * math.pi / 2)
        yield (
            f'<path class="rule" d="M{place:.1f},{base}v4" stroke="#888888" stroke-width="0.8"/>'
            f'<text x="{place:.1f}" y="{base + 16}" text-anchor="middle">{_phase(quarter)}</text>'
        )
    middle = (LEFT + right) / 2
    yield f'<text x="{middle}" y="{HEIGHT - 3}" text-anchor="middle">phase θ, rad</text>'


def _phase(quarters: int) -> str:
    """Return a multiple of π/2 in words of a tick."""
    if quarters % 2:
        return f"{'' if quarters == 1 else quarters}π/2"
    return "0" if quarters == 0 else f"{'' if quarters == 2 else quarters // 2}π"


def _upright(plane: _Plane, phase: float) -> str:
    place = plane.across(phase)
    return (
        f'<path class="rule" d="M{place:.1f},{TOP}V{HEIGHT - BOTTOM}" stroke="#888888" '
        f'stroke-width="0.8" stroke-dasharray="1.5 3"/>'
    )


def _legend() -> Iterator[str]:
    for row, name in enumerate(("input", "output", "harmonic")):
        level, start = 40 + 18 * row, WIDTH - RIGHT + 10
        width = 2.2 if name == "output" else 1.3
        yield (
            f'<path class="{name}" d="M{start},{level}h22" stroke="{COLOURS[name]}" stroke-width="{width}" '
            f'stroke-dasharray="{DASHES[name]}"/>'
            f'<text x="{start + 27}" y="{level + 4}">{NAMES[name]}</text>'
        )
