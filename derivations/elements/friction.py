"""Coulomb friction, the ideal relay and viscous friction under a sinusoid A sin θ (thesis, 2.48 to 2.52)."""

from functools import cache

import sympy

from derivations import assumed
from derivations.elements.waveform import THETA, Segment, Waveform
from derivations.symbols import A, omega

FORCE = assumed.positive("F_c")  # Coulomb friction force, N
LEVEL = assumed.positive("L")  # Output of a relay, in the unit of its output
DAMPING = assumed.positive("d")  # Coefficient of viscous friction, N s/m


def relay_waveform(level: sympy.Expr = FORCE) -> Waveform:
    """Return level · sign(A sin θ), in the unit of ``level``: the output of an ideal relay."""
    pi = sympy.pi
    return Waveform((Segment(sympy.Integer(0), pi, level), Segment(pi, 2 * pi, -level)))


@cache
def friction_waveform(force: sympy.Expr = FORCE) -> Waveform:
    """Return force · sign(d(A sin θ)/dt), N: Coulomb friction, which the velocity of its input switches."""
    pi = sympy.pi
    rising = sympy.solve(sympy.cos(THETA), THETA)
    turn, back = sorted(rising)
    return Waveform((Segment(turn, back, -force), Segment(back, turn + 2 * pi, force)))


def viscous_waveform() -> Waveform:
    """Return damping · d(A sin ωt)/dt, N: viscous friction of a displacement."""
    pi = sympy.pi
    force = DAMPING * omega * (A * sympy.sin(THETA)).diff(THETA)
    return Waveform((Segment(sympy.Integer(0), pi, force), Segment(pi, 2 * pi, force)))
