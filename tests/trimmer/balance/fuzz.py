"""Harmonic balance of random loops held against brute force.

A loop is *missed* if its certificate is complete, without a doubt, and a solution that brute force finds is
not in the list: that must not happen. It is *false* if a limit cycle in the list is no solution.
"""

import math
import warnings
from enum import Enum

import numpy as np

from tests.trimmer.balance.independent import Found, gain, limit_cycles_by_brute_force
from tests.trimmer.balance.wide_loops import WideLoop
from trimmer import ClosedLoop, HarmonicBalance, LimitCycle, TrimmerError, harmonic_balance
from trimmer.arrays import Reals

SAME = 1e-4  # Difference in ln omega, and a tenth of that in ln A, within which two solutions are one
RESIDUAL = 1e-5


class Outcome(Enum):
    """What came of a loop."""

    COMPLETE = "complete"
    DOUBTS = "with doubts"
    REFUSED = "refused"
    MISSED = "MISSED"
    FALSE = "FALSE"
    CRASHED = "CRASHED"


def judged(loop: WideLoop) -> tuple[Outcome, str]:
    """Solve a loop both ways; return what came of it, and details."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            balance = harmonic_balance(ClosedLoop(loop.system, loop.element))
    except TrimmerError as error:
        return Outcome.REFUSED, str(error)
    except Exception as error:  # whatever else it is, it is a fault
        return Outcome.CRASHED, repr(error)
    if not balance.certificate.complete:
        return Outcome.DOUBTS, "; ".join(balance.certificate.doubts)
    for cycle in balance.limit_cycles:
        if not residual(loop, cycle) < RESIDUAL:
            return Outcome.FALSE, f"{cycle} leaves {residual(loop, cycle):.3g}"
    missing = [each for each in limit_cycles_by_brute_force(loop) if is_missing(each, balance)]
    if missing:
        return Outcome.MISSED, f"{missing} of {balance.certificate}"
    return Outcome.COMPLETE, "" if balance.certificate.outside_excluded else "in its range"


def is_missing(found: Found, balance: HarmonicBalance) -> bool:
    """Whether a solution is one that the certificate excludes."""
    lowest, highest = balance.certificate.omegas
    covered = balance.certificate.outside_excluded or 1.001 * lowest < found.omega < 0.999 * highest
    return covered and not any(
        abs(math.log(cycle.omega / found.omega)) < SAME
        and abs(math.log(cycle.amplitude / found.amplitude)) < 10.0 * SAME
        for cycle in balance.limit_cycles
    )


def residual(loop: WideLoop, cycle: LimitCycle) -> float:
    """|1 + N G| by roots and formulas of the brute force, less what 1e-8 of omega and 5e-12 of A change."""
    omega, amplitude = np.array([cycle.omega]), np.array([cycle.amplitude])

    def excess(amplitude: Reals, omega: Reals) -> complex:
        inverse = np.exp(-loop.response.log_size(omega) - 1j * loop.response.phase(omega))
        return complex((gain(loop.element, amplitude, omega) / inverse)[0])

    with np.errstate(all="ignore"):
        value = excess(amplitude, omega)
        # Next to the edge of its domain N changes with the last digits of A.
        digits = [excess(amplitude * (1.0 + side * 4.5e-16), omega) - value for side in (-1.0, 1.0)]
        beside = excess(amplitude, omega * (1.0 + 1e-9)) - value
    steps = [abs(step) for step in digits if math.isfinite(abs(step))]
    return abs(1.0 + value) - 10.0 * abs(beside) - 1e4 * max(steps, default=0.0)
