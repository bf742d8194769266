"""Second ways of problems with dry friction: conveyor, belts, two blocks, the trimmer."""

from math import cos

import numpy as np

from benchmarks.problems.second_ways.closed import end_of_stick_slip
from benchmarks.problems.second_ways.contacts import TURN, measured, orbit, settled, sine
from benchmarks.problems.second_ways.elements import Contact, Friction
from benchmarks.problems.second_ways.fixed_point import fixed_point
from benchmarks.problems.second_ways.flight import Flight
from benchmarks.problems.second_ways.pieces import Machine


def belt(speed: float):
    """Return what takes the speed of a belt off that of a body."""
    return lambda t: (0.0, -speed, 0.0)


def conveyor() -> dict[str, float]:
    omega = TURN * 25.0

    def minus_trough(t: float) -> tuple[float, float, float]:
        first, second = sine(1e-3, omega)(t), sine(0.4e-3, 2 * omega, 0.9)(t)
        return tuple(-a - b for a, b in zip(first, second, strict=True))  # type: ignore[return-value]

    grip = Friction([1.0], lambda u: 0.3, 0.3, pin=minus_trough)
    machine = Machine(
        np.array([[0.1]]), np.zeros((1, 1)), np.zeros((1, 1)), lambda t: np.zeros(1), (), (grip,)
    )
    begun = settled(machine, 0.04, 40)[1:]
    v, derivative = fixed_point(
        lambda v: machine.fly(0.0, np.array([0.0, v[0]]), 0.04).state[1:], begun, np.array([0.1])
    )
    flight = machine.fly(0.0, np.array([0.0, v[0]]), 0.04)
    told = measured(flight, slip=lambda t, y: grip.u(t, y[1:]))
    return {**told, "advance": flight.state[0], "largest multiplier": abs(derivative[0, 0])}


def stick_slip(machine: Machine, until: float) -> Flight:
    """Return one cycle, from one end of stick to the next, once a start from rest is forgotten."""
    flight = machine.fly(0.0, np.zeros(2 * machine.n), until)
    ended = [event[0] for event in flight.events if event[2] != 0]
    return flight.between(*ended[-2:])


def falling_friction() -> dict[str, float]:
    rub = Friction(
        [1.0], lambda u: float(np.interp(u, [0, 0.5, 2], [1, 0.6, 0.5])), 1.0, pin=belt(0.2), knots=(0.5, 2.0)
    )
    machine = Machine(np.eye(1), np.zeros((1, 1)), np.eye(1), lambda t: np.zeros(1), (), (rub,))
    flight = stick_slip(machine, 32.0)
    return {**measured(flight, x=lambda t, y: y[0], v=lambda t, y: y[1]), "period": flight.length}


def damped_block() -> dict[str, float]:
    rub = Friction([1.0], lambda u: 0.5, 1.0, pin=belt(0.3))
    machine = Machine(np.eye(1), 0.1 * np.eye(1), np.eye(1), lambda t: np.zeros(1), (), (rub,))
    flight = stick_slip(machine, 28.0)
    return {
        "period": flight.length,
        "peak to peak of x": flight.peak_to_peak(lambda t, y: y[0]),
        "end of stick-slip": end_of_stick_slip(),
    }


def two_blocks() -> dict[str, float]:
    """From a state near the motion: state and period by Newton's method, on the section x_left = const."""
    rubs = tuple(
        Friction(w, lambda u, f=f: f, 2 * f, pin=belt(0.8))
        for w, f in (([1.0, 0.0], 0.5), ([0.0, 1.0], 0.65))
    )
    spring = np.array([[2.2, -1.2], [-1.2, 2.2]])
    machine = Machine(
        np.eye(2), np.array([[0.04, -0.02], [-0.02, 0.04]]), spring, lambda t: np.zeros(2), (), rubs
    )
    start = np.array([0.549, 0.543, -0.954, -0.952])

    def passage(x: np.ndarray) -> tuple[float, np.ndarray, Flight]:
        """Return when the left block falls through 0.549 again, from a state on that plane."""
        y = np.array([0.549, *x])
        flight = machine.fly(0.0, y, 7.5)
        time = flight.passes(lambda y: float(y[0]), 0.549)[-1]
        return time, next(s(time)[1:] for s, a, b, _ in flight.pieces if a <= time <= b), flight

    x, derivative = fixed_point(lambda x: passage(x)[1], start[1:], np.array([1.0, 1.0, 1.0]))
    period, _, flight = passage(x)
    cycle = flight.between(0.0, period)
    multipliers = np.linalg.eigvals(derivative)
    return {
        "period": period,
        "peak to peak of left": cycle.peak_to_peak(lambda t, y: y[0]),
        "peak to peak of right": cycle.peak_to_peak(lambda t, y: y[1]),
        "largest multiplier": float(max(abs(multipliers))),
    }


def stops_per_cycle() -> dict[str, float]:
    """Den Hartog's oscillator where it stops: the last of 32 periods; stick forgets the start."""
    omega = 0.4
    rub = Friction([1.0], lambda u: 0.6, 0.6)
    machine = Machine(
        np.eye(1), np.zeros((1, 1)), np.eye(1), lambda t: np.array([cos(omega * t)]), (), (rub,)
    )
    period = TURN / omega
    y = settled(machine, period, 30)
    y = machine.fly(30 * period, y, 31 * period).state
    flight = machine.fly(31 * period, y, 32 * period)
    stuck = sum(end - begin for _, begin, end, modes in flight.pieces if modes[0] == 0)
    return {**measured(flight, x=lambda t, y: y[0]), "share of stick": stuck / period}


def trimmer(frequency: float, friction: float, periods: int) -> dict[str, float]:
    """The thesis's trimmer with play: motor, cutter, housing, guard."""
    omega = TURN * frequency
    pin = sine(1.5e-3, omega)
    bridge = Contact([1.0, -1.0, 0.0, 0.0], 30e3, 0.4, -20e-6, 20e-6, pin)
    blade = Friction([0.0, 1.0, 0.0, -1.0], lambda u: friction, friction)
    machine = Machine(
        np.diag([0.035, 0.003, 0.005, 0.030]),
        np.array([[3.5, 0, 0, 0], [0, 0, 0, 0], [0, 0, 5.0, -4.0], [0, 0, -4.0, 4.0]], dtype=float),
        np.array([[200e3, 0, 0, 0], [0, 1e3, -1e3, 0], [0, -1e3, 251e3, -100e3], [0, 0, -100e3, 100e3]]),
        lambda t: np.zeros(4),
        (bridge,),
        (blade,),
    )
    start = settled(machine, 1 / frequency, periods, _from_rest(bridge))
    flight, multipliers = orbit(machine, 1 / frequency, start, [1e-3] * 4 + [1.0] * 4 + [1e-4])

    def motor(t: float, y: np.ndarray) -> float:
        piece = next(p for p in flight.pieces if p[1] <= t <= p[2])
        return float(machine.acceleration(t, y, piece[3])[0][0])

    told = measured(flight, stroke=lambda t, y: y[1] - y[3])
    return {
        **told,
        "rms acceleration of the motor": flight.mean(lambda t, y: motor(t, y) ** 2) ** 0.5,
        "largest multiplier": float(abs(multipliers[0])),
        "events per period": len(flight.events),
    }


def _from_rest(bridge: Contact) -> np.ndarray:
    s, _ = bridge.s(0.0, np.zeros(4), np.zeros(4))
    return np.array([0.0] * 8 + [s - float(np.clip(s, bridge.lower, bridge.upper))])


def trimmer_14() -> dict[str, float]:
    return trimmer(110.0, 1.0, 30)
