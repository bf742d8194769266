"""What the claims rest on: the motion between two turning points, solved, and exact orbits of the library."""

import math
from pathlib import Path
from typing import NamedTuple

from sympy import Expr, cos, pi, simplify, sin, solve, symbols

import trimmer

PAPER, HERTZ = Path(__file__).with_name("paper.md"), math.sqrt(2000 / 0.5) / (2 * math.pi)
TABLE = [row[2:-2].split(" | ") for row in PAPER.read_text("utf-8").splitlines() if row[2:3].isdigit()]
BETA, SHARE = symbols("beta rho", positive=True)  # ratio of frequencies, and F/P
V, U = 1 / (1 - BETA**2), sin(pi / BETA) / (BETA * (1 + cos(pi / BETA)))
APPROXIMATION = V**2 * (1 - (4 * SHARE / pi) ** 2)  # square of the amplitude per P/k


class Evidence(NamedTuple):
    """The forced sine per F/k, the square of the amplitude, exact amplitudes of orbits, and a work in J."""

    lag: Expr
    squared: Expr
    orbits: dict[float, float]
    heat: float


def amplitude(squared: Expr, beta: float, share: float = 0.3) -> float:
    """Return the amplitude per P/k of its square."""
    return math.sqrt(squared.subs({BETA: beta, SHARE: share}))


def gather() -> Evidence:
    """Solve the half period with falling displacement, and the orbits of the table."""
    t, start, free, other, force, sine = symbols("t x_0 A B c s", real=True)
    motion = SHARE + free * cos(t) + other * sin(t) + V * (force * cos(BETA * t) - sine * sin(BETA * t))
    speed, half = motion.diff(t), pi / BETA
    ends = [(motion - start, 0), (motion + start, half), (speed, 0), (speed, half)]
    found = solve([zero.subs(t, end) for zero, end in ends], [free, other, force, sine])
    per_start, lag = simplify(found[force] / start), simplify(found[sine])
    oscillator = trimmer.Mechanism.from_toml(PAPER.with_name("oscillator.toml"))
    driven = {float(row[0]): oscillator.with_value("frequency", float(row[0]) * HERTZ) for row in TABLE}
    measured = {beta: trimmer.forced_orbit(each).measures for beta, each in driven.items()}
    orbits = {beta: each.outputs["x"].peak_to_peak / 2 / 0.002 for beta, each in measured.items()}
    squared, heat = (1 - lag**2) / per_start**2, measured[1.5].frictions["guide"].work
    return Evidence(simplify(-V * lag / SHARE), squared, orbits, heat)
