"""G where friction and relays meet it, and simulations of loops with a relay."""

import control
import numpy as np
import sympy

from derivations import assumed
from derivations.symbols import s
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import ClosedLoop, Drive, OpenLoop, Relay, TrimmerParameters, pin_model, response_at, simulate
from trimmer.linear import InputChannels

SETTLED_AFTER = 60  # Periods of the drive after which the open loop with a relay is settled
DURATION = 0.02  # Of the motions that are compared, s


def fraction_of(numbers: LinearNumbers) -> tuple[sympy.Expr, sympy.Expr]:
    """Return numerator and denominator of G, with exact coefficients."""
    above, below = (
        sympy.Poly([sympy.Rational(c.numerator, c.denominator) for c in coefficients], s).as_expr()
        for coefficients in (numbers.numerator, numbers.denominator)
    )
    return above, below


def on_the_imaginary_axis(numbers: LinearNumbers) -> list[float]:
    """Return Im G, up to a positive factor, at every frequency above zero where Re G(jω) is zero."""
    frequency = assumed.real("omega")
    above, below = fraction_of(numbers)
    product = (above * below.subs(s, -s)).subs(s, sympy.I * frequency)
    real_part = sympy.Poly(sympy.re(product), frequency)
    imaginary_part = sympy.Poly(sympy.im(product), frequency)
    return [float(imaginary_part.eval(root)) for root in real_part.nroots(n=30) if root.is_real and root > 0]


def highest_phase(system: control.TransferFunction) -> float:
    """Return the largest phase of G (rad) on a grid of frequencies."""
    return float(np.angle(response_at(system, np.geomspace(1.0, 1e6, 20000))).max())


def difference_of_last_periods(parameters: TrimmerParameters, level: float) -> float:
    """Return how much the last two periods of the driven open loop with a relay differ, over their size."""
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    loop = OpenLoop(system, Relay(level), Drive(DRIVE_AMPLITUDE, DRIVE_OMEGA))
    motion = simulate(loop, SETTLED_AFTER / DRIVE_FREQUENCY)
    times = np.linspace(0, 1 / DRIVE_FREQUENCY, 401)
    last, before = (motion.output(motion.duration - turns / DRIVE_FREQUENCY + times) for turns in (1, 2))
    return float(abs(last - before).max() / abs(last).max())


def difference_of_scaled(parameters: TrimmerParameters, force: float) -> float:
    """Return how much ten times a relay's motion differs from that of ten times the relay.

    Over the largest displacement of the latter; each relay is struck by an impulse in its own proportion.
    """
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    times = np.linspace(0, DURATION, 401)
    first, second = (
        simulate(ClosedLoop(system, Relay(level)), DURATION, impulse=1e-3 * level).output(times)
        for level in (force, 10 * force)
    )
    return float(np.abs(10 * first - second).max() / np.abs(second).max())
