"""Second ways of problems with plays, stops and kinked springs."""

from math import cos, pi, sin

import numpy as np

from benchmarks.problems.second_ways.elements import Contact
from benchmarks.problems.second_ways.fixed_point import fixed_point
from benchmarks.problems.second_ways.flight import Flight
from benchmarks.problems.second_ways.pieces import Machine

TURN = 2.0 * pi


def sine(amplitude: float, omega: float, phase: float = 0.0):
    """Return displacement, velocity and acceleration of amplitude sin(omega t + phase), over time."""

    def at(t: float) -> tuple[float, float, float]:
        s, c = amplitude * sin(omega * t + phase), amplitude * cos(omega * t + phase)
        return s, omega * c, -(omega**2) * s

    return at


def settled(machine: Machine, period: float, periods: int, start=None) -> np.ndarray:
    """Return the state after some periods from a start, by default rest."""
    size = 2 * machine.n + len(machine.contacts) + machine.kept
    y, modes = np.zeros(size) if start is None else np.array(start, dtype=float), None
    for number in range(periods):
        flight = machine.fly(number * period, y, (number + 1) * period, modes, rtol=1e-8)
        y, modes = flight.state, flight.modes
    return y


def orbit(machine: Machine, period: float, start: np.ndarray, scale) -> tuple[Flight, np.ndarray]:
    """Return one period of the periodic motion near a state, and its multipliers, largest first."""
    scale = np.asarray(scale, dtype=float)
    begun = machine.begin(0.0, start)
    fixed = [i for i, mode in enumerate(begun[: len(machine.contacts)]) if mode or not machine.contacts[i].c]
    moved = np.array([i for i in range(len(start)) if i - 2 * machine.n not in fixed])

    def full(x: np.ndarray) -> np.ndarray:
        y = np.array(start, dtype=float)
        y[moved] = x
        for i in fixed:
            each = machine.contacts[i]
            edge = each.upper if begun[i] > 0 else each.lower
            q, v, _ = machine.split(y)
            y[2 * machine.n + i] = each.s(0.0, q, v)[0] - edge if each.c else 0.0
        return y

    def after(x: np.ndarray) -> np.ndarray:
        return machine.fly(0.0, full(x), period, begun).state[moved]

    x, derivative = fixed_point(after, start[moved], scale[moved])
    multipliers = np.linalg.eigvals(derivative)
    return machine.fly(0.0, full(x), period, begun), multipliers[np.argsort(-abs(multipliers))]


def measured(flight: Flight, **outputs) -> dict[str, float]:
    """Return peak to peak and rms about the mean of outputs."""
    told = {}
    for name, of in outputs.items():
        told[f"peak to peak of {name}"] = flight.peak_to_peak(of)
        mean = flight.mean(of)
        told[f"rms of {name}"] = flight.mean(lambda t, y, of=of, mean=mean: (of(t, y) - mean) ** 2) ** 0.5
    return told


def lever_play() -> dict[str, float]:
    omega = TURN * 40.0
    joint = Contact([-0.05, -1.0, 1.0], 15e3, 2.0, -0.05e-3, 0.05e-3)
    machine = Machine(
        np.diag([2e-5, 0.2, 0.05]),
        np.diag([1e-3, 8.0, 1.5]),
        np.diag([2.0, 20e3, 2e3]),
        lambda t: np.array([0.06 * sin(omega * t), 0.0, 0.0]),
        (joint,),
    )
    flight, multipliers = orbit(
        machine, 1 / 40.0, settled(machine, 1 / 40.0, 40), [1e-2, 1e-3, 1e-3, 1.0, 0.1, 0.1, 1e-4]
    )
    tension = _tension(machine, flight)
    told = measured(
        flight, slide=lambda t, y: y[2], tip=lambda t, y: 0.05 * y[0] + y[1], angle=lambda t, y: y[0]
    )
    return {
        **told,
        **tension,
        "largest multiplier": abs(multipliers[0]),
        "events per period": len(flight.events),
    }


def _tension(machine: Machine, flight: Flight) -> dict[str, float]:
    """Return largest less smallest force of the first contact, both sides of each jump counted."""
    low, high = 0.0, 0.0
    for solution, begin, end, modes in flight.pieces:
        piece = Flight([(solution, begin, end, modes)])
        a, b = piece.extremes(lambda t, y, mode=modes[0]: machine.tension(t, y, 0, mode))
        low, high = min(low, a), max(high, b)
    return {"peak to peak of the force": high - low}


def structure_stop() -> dict[str, float]:
    omega = TURN * 25.0
    machine = Machine(
        np.array([[1.2, 0.3, 0.15], [0.3, 0.9, 0.08], [0.15, 0.08, 1.0]]),
        np.array([[7.0, -1.5, 0.0], [-1.5, 5.0, 0.0], [0.0, 0.0, 12.0]]),
        np.array([[40e3, -15e3, 0.0], [-15e3, 30e3, 0.0], [0.0, 0.0, 250e3]]),
        lambda t: np.array([30.0 * sin(omega * t), 0.0, 0.0]),
        (Contact([0.0, 1.0, 0.0], 200e3, 40.0, -np.inf, 0.2e-3),),
    )
    start = settled(machine, 0.04, 60)
    flight, multipliers = orbit(machine, 0.04, start, [1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1, 1e-4])
    told = measured(flight, u1=lambda t, y: y[0], u2=lambda t, y: y[1])
    return {**told, **_tension(machine, flight), "largest multiplier": abs(multipliers[0])}


def gear_rattle() -> dict[str, float]:
    omega, half = TURN * 30.0, 0.2 * pi / 180.0

    def moment(t: float) -> np.ndarray:
        ripple = sin(omega * t) + 0.5 * sin(2 * omega * t + 0.3) + 0.2 * sin(4 * omega * t - 1.0)
        return np.array([ripple, 0.0])

    machine = Machine(
        np.diag([5e-4, 1.2e-3]),
        np.diag([0.02, 0.02]),
        np.diag([50.0, 5.0]),
        moment,
        (Contact([-0.5, 1.0], 300.0, 0.05, -half, half),),
    )
    flight, multipliers = orbit(machine, 1 / 30, settled(machine, 1 / 30, 40), [0.03, 0.03, 5.0, 5.0, 1e-3])
    told = measured(flight, drive=lambda t, y: y[0], gear=lambda t, y: y[1])
    return {**told, **_tension(machine, flight), "largest multiplier": abs(multipliers[0])}


def hardening_spring() -> dict[str, float]:
    omega = TURN * 0.25
    spring = Contact([1.0], 3.0, 0.0, -1.0, 1.0)
    machine = Machine(
        np.eye(1), np.array([[0.15]]), np.eye(1), lambda t: np.array([4.0 * sin(omega * t)]), (spring,)
    )
    flight, multipliers = orbit(machine, 4.0, settled(machine, 4.0, 60), [1.0, 1.0, 1.0])
    return {**measured(flight, x=lambda t, y: y[0]), "largest multiplier": abs(multipliers[0])}


def preloaded_stop() -> dict[str, float]:
    def push(t: float) -> np.ndarray:
        return np.array([np.interp(t, [0.01, 0.012, 0.02, 0.022], [0.0, 1.5, 1.5, 0.0]) - 0.4])

    machine = Machine(
        np.array([[0.01]]),
        np.array([[0.05]]),
        np.array([[100.0]]),
        push,
        (Contact([-1.0], 50e3, 2.0, -np.inf, -0.5e-3),),
        breaks=(0.01, 0.012, 0.02, 0.022),
    )
    # From rest the spring of the stop is stretched by s - gap.
    flight = machine.fly(0.0, np.array([0.0, 0.0, 0.5e-3]), 0.12)
    times = [event[0] for event in flight.events]
    return {
        "number of events": len(times),
        "first release": times[0],
        "first return": times[1],
        "last release": times[-1],
        "speed of the first return": flight.events[1][3],
        "displacement at 0.12 s": flight.state[0],
        "velocity at 0.12 s": flight.state[1],
    }
