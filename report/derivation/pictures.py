"""Pictures of the waveforms that the describing functions are derived from, drawn from the derivation."""

from dataclasses import replace
from typing import Final

import numpy as np
import sympy

from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    contact_ratio,
    friction_waveform,
    general_waveform,
    inertia_contact_ratio,
    inertia_waveform,
    separation_angle,
)
from derivations.elements.friction import DAMPING, FORCE, LEVEL, relay_waveform, viscous_waveform
from derivations.elements.friction import friction_waveform as coulomb_waveform
from derivations.elements.waveform import THETA, Waveform
from derivations.symbols import A, omega
from report.derivation.waveform_svg import WaveformPiece, waveform_svg
from report.judging.text import one_line
from report.pages.figure import Figure

Values = dict[sympy.Expr, sympy.Expr]
POINTS: Final = 33  # Points on each segment
TITLE: Final = "Waveform, with the input and the first harmonic"
RATIO: Final = sympy.Rational(6, 10)  # Gap over amplitude where the load has no inertia
LOAD: Final = sympy.Rational(5, 4)  # γ of the general load
IMPACT: Final = sympy.Rational(9, 4)  # Phase of the impact where the load has inertia, rad


def _values() -> dict[str, tuple[Waveform, Values]]:
    """Return the waveform of each step and values of its symbols that belong together."""
    unit: Values = {A: sympy.Integer(1)}
    angle = separation_angle().subs(GAMMA, LOAD)
    general: Values = unit | {
        GAMMA: LOAD,
        SEPARATION: angle,
        CONTACT: IMPACT,
        GAP: contact_ratio().subs({SEPARATION: angle, GAMMA: LOAD, CONTACT: IMPACT}),
    }
    inertia: Values = unit | {CONTACT: IMPACT, GAP: inertia_contact_ratio().subs(CONTACT, IMPACT)}
    return {
        "df-relay": (relay_waveform(LEVEL), {LEVEL: sympy.Rational(7, 10)}),
        "df-coulomb-friction": (coulomb_waveform(), {FORCE: sympy.Rational(7, 10)}),
        "df-viscous-friction": (viscous_waveform(), unit | {omega: sympy.Integer(1), DAMPING: RATIO}),
        "df-friction-backlash": (friction_waveform(), unit | {GAP: RATIO}),
        "df-inertia-backlash": (inertia_waveform(), inertia),
        "df-general-backlash": (general_waveform(), general),
    }


def waveform_pictures() -> dict[str, Figure]:
    """Return the picture of each step that begins with a waveform, by the step's id."""
    return {step: _picture(step, waveform, values) for step, (waveform, values) in _values().items()}


def friction_backlash_picture(step: str) -> Figure:
    """Return the picture of play with a load that friction holds, for a step that tells it in short."""
    caption = "Input, output, and the sine that stands for the output, for a gap of 0.6 of the amplitude."
    return replace(_picture(step, *_values()["df-friction-backlash"]), caption=caption)


def _picture(step: str, waveform: Waveform, values: Values) -> Figure:
    words = one_line(f"""
        The output y over one period in {len(waveform.segments)} parts, the input A sin θ and the output's
        first harmonic; the describing function is the ratio of the last two.
    """)
    svg = waveform_svg(f"waveform-{step}", TITLE, words, sampled(waveform, values))
    return Figure(f"waveform-{step}", TITLE, _caption(values), words, svg)


def _caption(values: Values) -> str:
    shown = ((GAP, "g/A"), (GAMMA, r"\gamma"))
    given = ", ".join(f"${name} = {float(values[symbol]):.3g}$" for symbol, name in shown if symbol in values)
    upright = (
        "Vertical lines are drawn where one piece ends and the next begins; each is integrated by itself."
    )
    return f"{upright} Drawn for {given}." if given else upright


def sampled(waveform: Waveform, values: Values) -> tuple[WaveformPiece, ...]:
    """Return the phases (rad) and the output of each segment of one period."""
    pieces = []
    for segment in waveform.segments:
        start, end = (float(each.subs(values)) for each in (segment.start, segment.end))
        inside = np.linspace(start, end, POINTS)
        output = sympy.lambdify(THETA, segment.value.subs(values), "numpy")
        pieces.append(WaveformPiece(inside, np.broadcast_to(output(inside), inside.shape)))
    return tuple(pieces)
