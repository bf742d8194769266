"""What the claims rest on: the motion between two turning points, solved, and exact orbits of the library."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import sympy
from sympy import cos, pi, sin

import trimmer
from trimmer.response import MechanismOrbit

BETA, SHARE = sympy.symbols("beta rho", positive=True)  # ratio of frequencies, and F/P
V, U = 1 / (1 - BETA**2), sin(pi / BETA) / (BETA * (1 + cos(pi / BETA)))
NATURAL = math.sqrt(2000 / 0.5)  # rad/s


@dataclass(frozen=True)
class Evidence:
    """The forced sine per F/k, the square of the amplitude per P/k, and orbits by their ratio."""

    lag: sympy.Expr
    squared: sympy.Expr
    orbits: Mapping[float, MechanismOrbit]

    def exact(self, beta: float, share: float = 0.3) -> float:
        """Return the amplitude per P/k that the conditions at the turning points give."""
        return math.sqrt(self.squared.subs({BETA: beta, SHARE: share}))

    def orbit(self, beta: float) -> float:
        """Return the amplitude per P/k of the library's orbit."""
        return self.orbits[beta].measures.outputs["x"].peak_to_peak / 2 / 0.002


def gather() -> Evidence:
    """Solve the half period with falling displacement, and the orbits of the table."""
    time, start, free, other, force, sine = sympy.symbols("t x_0 A B c s", real=True)
    drive = force * cos(BETA * time) - sine * sin(BETA * time)
    motion = SHARE + free * cos(time) + other * sin(time) + V * drive
    speed, half = motion.diff(time), pi / BETA
    ends = [motion.subs(time, 0) - start, motion.subs(time, half) + start]
    ends += [speed.subs(time, 0), speed.subs(time, half)]
    found = sympy.solve(ends, [free, other, force, sine])
    per_start, lag = sympy.simplify(found[force] / start), sympy.simplify(found[sine])
    oscillator = trimmer.Mechanism.from_toml(Path(__file__).with_name("oscillator.toml"))
    ratios = {beta: f"{beta * NATURAL / (2 * math.pi)!r} Hz" for beta in (0.6, 0.8, 1.2, 1.5, 2.0)}
    orbits = {b: trimmer.forced_orbit(oscillator.with_value("frequency", each)) for b, each in ratios.items()}
    return Evidence(sympy.simplify(-V * lag / SHARE), (1 - lag**2) / per_start**2, orbits)


def approximate(beta: float, share: float = 0.3) -> float:
    """Return the amplitude per P/k of equation 7."""
    return math.sqrt(1 - (4 * share / math.pi) ** 2) / abs(1 - beta**2)
