"""What the sample report shows of a derivation besides equations: code, a picture, a slip's way, sliders."""

import numpy as np

from report.derivation.waveform_svg import WaveformPiece, waveform_svg
from report.document.extras import Explorable
from report.judging.spread import Follows
from report.pages.explorable import Panel, Slider
from report.pages.figure import CodeLines, Figure

CODE = CodeLines(
    "trimmer/linear/low_pass.py", "bandwidth", 29, 31, "def bandwidth(x: float) -> float:\n    return x < 2"
)
"""Three lines of code with what HTML takes for markup."""

SPREAD = (
    Follows("eq-2.9", "eq-2.8", "put in"),
    Follows("fig-5.1", "eq-2.9", "drawn with it & more"),
    Follows("tab-5.1", "fig-5.1", "read off"),
)

FORMULAS = """
const explorableFormulas = {
  inverseResponse: (omega, damping, share) => (
    { real: -omega / 5000, imaginary: 0.1, realByOmega: -1 / 5000, imaginaryByOmega: 0 }),
  rubbing: () => ({ real: 1, imaginary: 0, realByOmega: 0, imaginaryByOmega: 0 }),
  polynomials: () => ({ %s }),
  element: (flight, gamma) => ({
    separation: 0, ratio: flight, real: 1 - flight / 4, imaginary: -flight / 4, ratioByFlight: 1,
    realByFlight: -1 / 4, imaginaryByFlight: -1 / 4, ratioByGamma: 0, realByGamma: 0, imaginaryByGamma: 0 }),
  friction: (force, amplitude) => (
    { imaginary: force / amplitude / 1e4, imaginaryByAmplitude: -force / amplitude ** 2 / 1e4 }),
  flight: (phase) => ({ position: phase }),
  contact: (phase) => ({ position: Math.sin(phase) }),
};
"""
"""A loop with one limit cycle without friction, at 4500 rad/s."""


def picture(identifier: str = "waveform-relay") -> Figure:
    """Return the picture of a relay's waveform."""
    title, words = "Waveform & input", "A sine, and a line that jumps with its sign."
    halves = (np.linspace(0, np.pi, 5), np.linspace(np.pi, 2 * np.pi, 5))
    pieces = tuple(
        WaveformPiece(phases, np.full(5, sign)) for phases, sign in zip(halves, (0.7, -0.7), strict=True)
    )
    svg = waveform_svg(identifier, title, words, pieces)
    return Figure(identifier, title, "Drawn for $L = 0.7$.", words, svg)


def explorable() -> Explorable:
    """Return two sliders, a panel of each kind, and formulas that are easy to follow."""
    coefficients = np.poly([-1000.0 * number for number in range(1, 9)])
    named = [f"a{power}: {value}" for power, value in zip(range(8, -1, -1), coefficients, strict=True)]
    named += [f"{name}{power}: 0" for name in "bh" for power in range(9)]
    return Explorable(
        FORMULAS % ", ".join(named),
        (
            Slider("gap", "Gap", -6.0, -3.0, -4.0, True, 1e6, "µm"),
            Slider("load", "Load", -6.0, -1.0, -3.0, True, 1e3, "ms"),
            Slider("damping", "Damping", 0.0, 2.0, 0.4, False, 1.0, "N s/m"),
            Slider("force", "Friction & more", 0.0, 2.0, 0.0, False, 1.0, "N"),
            Slider("share", "Share", 0.0, 1.0, 0.0, False, 100.0, "%"),
        ),
        (
            Panel("The whole plane.", (-3.0, 3.0, -3.0, 3.0), "Locus and contour"),
            Panel("Near −1.", (-1.5, 0.5, -0.5, 0.5), "Locus and contour near minus one"),
            Panel("Over a period.", (0.0, 6.3, -1.2, 1.2), "Pin and load"),
        ),
        picture("explorable-still"),
    )
