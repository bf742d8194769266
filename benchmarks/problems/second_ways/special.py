"""Second ways of special points: folds, period doublings, tori, and where the linear motion grazes.

Contacts without damping give a continuous right-hand side, so that the derivative of a period is the product
of the exponentials of its pieces, whose durations DOP853 has found.
"""

from collections.abc import Callable
from math import cos

import mpmath
import numpy as np
from mpmath import mp, mpf
from scipy.optimize import brentq, root

from benchmarks.problems.second_ways.contacts import TURN
from benchmarks.problems.second_ways.elements import Contact
from benchmarks.problems.second_ways.pieces import Machine


class Strobe:
    """Periodic motions and special points of machines whose contacts have no damping, over omega."""

    def __init__(self, of_omega: Callable[[float], Machine]) -> None:
        self.of_omega = of_omega

    def flown(self, omega: float, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the end of a period, and the derivative of it."""
        machine = self.of_omega(omega)
        start = np.concatenate([x, np.zeros(len(machine.contacts))])
        flight = machine.fly(0.0, start, TURN / omega)
        return flight.state[: len(x)], machine.monodromy(flight)

    def special(self, kind: str, omega: float, x: np.ndarray) -> tuple[float, np.ndarray]:
        """Return omega and state where det(M - 1), det(M + 1) or |complex multiplier|^2 - 1 is zero."""

        def lacking(unknown: np.ndarray) -> np.ndarray:
            end, derivative = self.flown(unknown[-1], unknown[:-1])
            return np.append(end - unknown[:-1], _test(kind, derivative))

        found = root(lacking, np.append(x, omega), tol=1e-13, options={"eps": 1e-8, "xtol": 1e-13})
        return float(found.x[-1]), found.x[:-1]


def _test(kind: str, derivative: np.ndarray) -> float:
    unit = np.eye(len(derivative))
    if kind == "fold":
        return float(np.linalg.det(derivative - unit))
    if kind == "period doubling":
        return float(np.linalg.det(derivative + unit))
    values = np.linalg.eigvals(derivative)
    turning = values[abs(values.imag) > 1e-6]
    return float(min(abs(turning) ** 2 - 1.0, key=abs)) if turning.size else 1.0


def swing(machine: Machine, amplitudes: list[complex], omega: float) -> np.ndarray:
    """Return the complex amplitudes of the linear motion under forces Re(F exp(i omega t))."""
    dynamic = machine.stiffness - omega**2 * machine.mass + 1j * omega * machine.damping
    return np.linalg.solve(dynamic, np.asarray(amplitudes))


def oscillator_stop() -> dict[str, float]:
    def of(omega: float) -> Machine:
        stop = Contact([1.0], 1000.0, 0.0, -np.inf, 10.0)
        unit = np.eye(1)
        return Machine(
            unit, 0.1 * 40**0.5 * unit, 40.0 * unit, lambda t: np.array([100.0 * cos(omega * t)]), (stop,)
        )

    strobe = Strobe(of)
    return {
        "upper fold": strobe.special("fold", 8.5664, np.array([-10.870, 123.76]))[0],
        "lower fold": strobe.special("fold", 6.99763, np.array([-8.9684, 30.978]))[0],
        "first period doubling": strobe.special("period doubling", 5.5567, np.array([9.379, 20.105]))[0],
        "second period doubling": strobe.special("period doubling", 5.7079, np.array([9.3283, 24.909]))[0],
        "lower grazing": _grazes(of, [100.0], 0, 10.0, (5.4, 5.7)),
        "upper grazing": _grazes(of, [100.0], 0, 10.0, (6.9, 7.1)),
    }


def _grazes(of: Callable, amplitudes: list, body: int, reach: float, between: tuple[float, float]) -> float:
    def beyond(omega: float) -> float:
        return float(abs(swing(of(omega), amplitudes, omega)[body])) - reach

    return brentq(beyond, *between, xtol=1e-15)


def two_mass_stop() -> dict[str, float]:
    stiffness = np.array([[1.0, -1.0], [-1.0, 2.0]])

    def of(omega: float) -> Machine:
        stop = Contact([1.0, 0.0], 100.0, 0.0, -np.inf, 1.0)
        return Machine(
            np.eye(2), 0.03 * stiffness, stiffness, lambda t: np.array([0.0, 0.1 * cos(omega * t)]), (stop,)
        )

    strobe = Strobe(of)
    starts = {
        "fold": (0.755627, [-0.67603, -0.8176, 1.05088, 0.19077]),
        "first period doubling": (0.738783, [0.44547, 0.4633, 0.64173, 1.01734]),
        "second period doubling": (0.755586, [-0.60289, -0.81068, 1.0397, 0.27409]),
        "torus": (0.618607, [0.97277, 0.64514, 0.2483, 0.07051]),
    }
    told = {}
    for name, (omega, x) in starts.items():
        kind = name.removeprefix("first ").removeprefix("second ")
        told[name] = strobe.special(kind, omega, np.array(x))[0]
    told["lower grazing"] = _grazes(of, [0.0, 0.1], 0, 1.0, (0.57, 0.6))
    told["upper grazing"] = _grazes(of, [0.0, 0.1], 0, 1.0, (0.645, 0.67))
    return told


def dead_zone() -> dict[str, float]:
    def of(omega: float) -> Machine:
        zone = Contact([1.0], 1.0, 0.0, -1.0, 1.0)
        return Machine(
            np.eye(1),
            0.1 * np.eye(1),
            np.zeros((1, 1)),
            lambda t: np.array([0.1 + 0.05 * omega**2 * cos(omega * t)]),
            (zone,),
        )

    strobe = Strobe(of)

    def touches(omega: float) -> float:
        # In touch all the time, x = 1.1 + the swing of a spring of 1; it just reaches 1.
        return 0.05 * omega**2 / abs(1.0 - omega**2 + 0.1j * omega) - 0.1

    return {
        "upper fold": strobe.special("fold", 0.82846, np.array([1.21222, 0.02869]))[0],
        "lower fold": strobe.special("fold", 0.70803, np.array([1.00324, 0.24672]))[0],
        "lower loss of contact": brentq(touches, 0.7, 0.9, xtol=1e-15),
        "upper loss of contact": brentq(touches, 1.2, 1.6, xtol=1e-15),
    }


def rigid_stop() -> dict[str, float]:
    """One impact in a period, on paper: time and speed of an impact map to those of the next (mpmath)."""
    with mpmath.workdps(30):
        return {key: float(value) for key, value in _rigid_stop().items()}


def _rigid_stop() -> dict[str, mpf]:
    delta, e, gap = mpf("0.1"), mpf("0.7"), mpf("1.8")
    own = mpmath.sqrt(1 - delta**2)

    def free(t, w, begin, after):
        """Return x and x' at t of what leaves the wall at a time with a speed, under sin(w t)."""
        turn = 1 / (1 - w**2 + 2j * delta * w)

        def forced(at):
            wave = turn * mpmath.expj(w * at)
            return mpmath.im(wave), mpmath.im(1j * w * wave)

        x, v = gap - forced(begin)[0], -after - forced(begin)[1]
        share = mpmath.mpc(x, -(v + delta * x) / own) * mpmath.exp(mpmath.mpc(-delta, own) * (t - begin))
        a, b = forced(t)
        return share.real + a, (share * mpmath.mpc(-delta, own)).real + b

    def trace(w, begin, after):
        period = 2 * mp.pi / w

        def back(b, a):
            end = mpmath.findroot(lambda t: free(t, w, b, a)[0] - gap, begin + period)
            return end - period, e * free(end, w, b, a)[1]

        step = mpf(10) ** -10
        up, down = back(begin + step, after), back(begin - step, after)
        more, less = back(begin, after + step), back(begin, after - step)
        return (up[0] - down[0] + more[1] - less[1]) / (2 * step)

    def where(multiplier, w, begin, after):
        """Return w where a multiplier is 1 or -1; their product is e^2 exp(-2 delta T)."""

        def lacking(w, begin, after):
            x, v = free(begin + 2 * mp.pi / w, w, begin, after)
            product = e**2 * mpmath.exp(-4 * mp.pi * delta / w)
            return [x - gap, e * v - after, 1 - multiplier * trace(w, begin, after) + product]

        return mpmath.findroot(lacking, (w, begin, after), tol=1e-18)[0]

    squares = sorted(mpmath.polyroots([1, (2 * delta) ** 2 - 2, 1 - 1 / gap**2]))
    return {
        "lower grazing": mpmath.sqrt(squares[0]),
        "upper grazing": mpmath.sqrt(squares[1]),
        "period doubling": where(-1, *(mpf(each) for each in GUESSES["period doubling"])),
        "fold": where(1, *(mpf(each) for each in GUESSES["fold"])),
    }


GUESSES = {"period doubling": ("0.68124", "2.6195", "0.0594"), "fold": ("1.4325389", "2.3806", "1.672")}
