"""The laws of curves: forces that are straight between points, as statements beside the equations."""

from dataclasses import dataclass
from itertools import pairwise

import sympy

from derivations.algebra.unevaluated import product, total
from derivations.mechanism import elongation
from derivations.parts import CurvedSpring, Points


@dataclass(frozen=True)
class CurveStatement:
    """The law of one spring with a curve."""

    spring: CurvedSpring  # The spring
    distance: sympy.Expr  # s in the coordinates of bodies and pins, m
    tension: sympy.Expr  # T, N, as a function of s


def curve_statement(spring: CurvedSpring) -> CurveStatement:
    """State the law of a spring with a curve."""
    return CurveStatement(spring, elongation(spring), straight_between(spring.points, spring.distance))


def straight_between(points: Points, over: sympy.Expr, *, level: bool = False) -> sympy.Expr:
    """Return a function that is straight between points, as cases that stay as they are written.

    Args:
        points: At least two, or one if it is level.
        over: What it is a function of.
        level: Whether it is constant beyond the last point; otherwise it goes on as before.
    """
    lines = [
        total(first, product((second - first) / (after - before), total(over, -before)))
        for (before, first), (after, second) in pairwise(points)
    ]
    corners = [corner for corner, _ in points[1:]]
    if level:
        lines.append(points[-1][1])
    cases = [
        (line, sympy.Lt(over, corner, evaluate=False))
        for line, corner in zip(lines[:-1], corners, strict=False)
    ]
    return sympy.Piecewise(*cases, (lines[-1], sympy.true), evaluate=False) if cases else lines[-1]
