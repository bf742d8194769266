"""Coulomb friction and the ideal relay under a sinusoid A sin θ (thesis, equations 2.48 to 2.52)."""

from __future__ import annotations

import sympy

from derivations.waveform import THETA, Segment, Waveform

FORCE = sympy.Symbol("F_c", positive=True)
"""Coulomb friction force, N."""


def relay_waveform(level: sympy.Expr = FORCE) -> Waveform:
    """Return level · sign(A sin θ): the output of a relay that its own input switches."""
    pi = sympy.pi
    return Waveform((Segment(sympy.Integer(0), pi, level), Segment(pi, 2 * pi, -level)))


def friction_waveform(force: sympy.Expr = FORCE) -> Waveform:
    """Return force · sign(d(A sin θ)/dt): Coulomb friction, switched by the velocity of its input."""
    pi = sympy.pi
    rising = sympy.solve(sympy.cos(THETA), THETA)
    turn, back = sorted(rising)
    return Waveform((Segment(turn, back, -force), Segment(back, turn + 2 * pi, force)))
