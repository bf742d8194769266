"""Second ways of problems with controllers."""

import mpmath
import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq, newton

from benchmarks.problems.second_ways.elements import Contact, Friction
from benchmarks.problems.second_ways.flight import Flight
from benchmarks.problems.second_ways.pieces import Machine


def limited(u: float, limit: float) -> float:
    """Return what acts."""
    return min(max(u, -limit), limit)


def stiction_pid() -> dict[str, float]:
    """Half a cycle is a map of the error e at which the motor breaks away; it is -e after half a cycle."""
    kp, ki, kd, filter_time = 6.0, 120.0, 0.05, 1e-3

    def control(t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        e, integral, z = -y[0], y[2], y[3]
        return np.array([kp * e + integral + kd * (e - z) / filter_time]), np.array(
            [ki * e, (e - z) / filter_time]
        )

    machine = Machine(
        np.array([[2e-4]]),
        np.zeros((1, 1)),
        np.zeros((1, 1)),
        lambda t: np.zeros(1),
        (),
        (Friction([1.0], lambda u: 0.05, 0.08),),
        control=control,
        kept=2,
    )

    def half(e: float) -> tuple[float, float]:
        flight = machine.fly(0.0, np.array([-e, 0.0, 0.08 - kp * e, e]), 0.6, (1,))
        time = next(event[0] for event in flight.events if event[2] != 0)
        solution = next(piece[0] for piece in flight.pieces if piece[1] <= time <= piece[2])
        return time, -float(solution(time)[0])

    e = float(newton(lambda e: half(e)[1] + e, 0.0025, x1=0.0026, tol=1e-16, rtol=1e-13))
    step = 1e-4 * e
    slope = (half(e + step)[1] - half(e - step)[1]) / (2 * step)
    return {"period": 2 * half(e)[0], "amplitude": e, "largest multiplier": slope**2}


def two_masses(gap: float, loads: tuple[float, float, float, float], viscous: float, **more) -> Machine:
    """Return motor and load behind a shaft with play, each with friction."""
    kinetic, static, of_load, static_of_load = loads
    return Machine(
        np.diag([2e-4, 5e-4]),
        np.zeros((2, 2)),
        np.zeros((2, 2)),
        lambda t: np.zeros(2),
        (Contact([-1.0, 1.0], 80.0, 0.02, -gap / 2, gap / 2),),
        (
            Friction([1.0, 0.0], lambda u: kinetic, static),
            Friction([0.0, 1.0], lambda u: of_load, static_of_load, viscous),
        ),
        **more,
    )


def servo_to_rest() -> dict[str, float]:
    def demand(y: np.ndarray) -> float:
        e = 0.5 - y[0]
        return 6.0 * e + 0.09 * (e - y[5]) / 1e-3

    def control(t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.array([limited(demand(y), 2.0), 0.0]), np.array([(0.5 - y[0] - y[5]) / 1e-3])

    corners = [lambda t, y, side=side: demand(y) - side * 2.0 for side in (1, -1)]
    machine = two_masses(0.01, (0.05, 0.08, 0.08, 0.12), 1e-3, control=control, corners=corners, kept=1)
    flight = machine.fly(0.01, np.zeros(6), 0.4)

    def motor(y: np.ndarray) -> float:
        return float(y[0])

    tenth, most = (flight.passes(motor, share * 0.5)[0] for share in (0.1, 0.9))
    return {
        "motor at the end": flight.state[0],
        "load at the end": flight.state[1],
        "rise time": most - tenth,
        "settling time": flight.passes(motor, 0.49)[-1] - 0.01,
        "last event": flight.events[-1][0],
    }


def sampled_servo() -> dict[str, float]:
    """The torque is constant between switchings of the hold; the clock is kept by whole numbers."""
    held = [0.0]

    def control(t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.array([held[0], 0.0]), np.zeros(0)

    machine = two_masses(0.006, (0.03, 0.04, 0.04, 0.06), 0.0, control=control)
    kp, ki, kd, filter_time, sample, limit = 3.0, 10.0, 0.06, 1e-3, 5e-4, 1.0
    ticks = [(k * sample, 0, k) for k in range(601)]
    ticks = sorted(ticks + [(k * sample + 1.15e-3, 1, k) for k in range(598)])
    y, t, modes, z, integral = np.zeros(5), 0.0, (0, 0, 0), 0.0, 0.0
    controls: list[float] = []
    flight = Flight()
    for time, what, k in ticks:
        if time > 0.3:
            break
        if time > t:
            part = machine.fly(t, y, time, modes)
            flight.pieces.extend(part.pieces)
            y, modes, t = part.state, part.modes, time
        if what == 0:
            e = (0.4 if time >= 0.0103 else 0.0) - y[0]
            z += sample / (filter_time + sample) * (e - z)
            w = kp * e + integral + ki * sample * e + kd * (e - z) / filter_time
            controls.append(limited(w, limit))
            integral += ki * sample * e + sample / (kp / ki) * (controls[-1] - w)
        else:
            held[0] = controls[k]
            modes = machine.settled(t, y, modes)
    top = flight.extremes(lambda t, y: y[0])[1]
    return {"motor at the end": y[0], "load at the end": y[1], "overshoot": 100.0 * (top - 0.4) / 0.4}


def sampled_axis() -> dict[str, float]:
    """Linear: matrix exponentials of the half samples between which the torque is constant."""
    kp, ki, kd, filter_time, sample = 1.5, 10.0, 0.04, 0.002, 0.001
    inverse = np.diag([1 / 2e-4, 1 / 5e-4])
    spring = 80.0 * np.array([[1.0, -1.0], [-1.0, 1.0]])
    damper = 0.02 * np.array([[1.0, -1.0], [-1.0, 1.0]]) + 1e-3 * np.eye(2)
    flow = np.zeros((5, 5))
    flow[:2, 2:4], flow[2:4, :2], flow[2:4, 2:4] = np.eye(2), -inverse @ spring, -inverse @ damper
    flow[2, 4] = inverse[0, 0]
    half = expm(flow * sample / 2)
    x, z, integral, top = np.zeros(5), 0.0, 0.0, 0.0
    for k in range(400):
        e = (0.5 if k * sample >= 0.0102 else 0.0) - x[0]
        z += sample / (filter_time + sample) * (e - z)
        new = kp * e + integral + ki * sample * e + kd * (e - z) / filter_time
        integral += ki * sample * e
        for part in range(2):
            x[4] = new if part else x[4]
            end = half @ x
            if x[2] > 0 > end[2]:
                peak = brentq(lambda t, x=x: (expm(flow * t) @ x)[2], 0.0, sample / 2, xtol=1e-16)
                top = max(top, float((expm(flow * peak) @ x)[0]))
            x = end
    return {
        "motor at the end": x[0],
        "load at the end": x[1],
        "overshoot": 100.0 * (top - 0.5) / 0.5,
        "final error": 0.5 - x[0],
    }


def relay_loop() -> dict[str, float]:
    """G = 4/(s+1)^3 under a relay of 1: half a period h with x(h) = -x(0) and output 0 at both (mpmath)."""
    with mpmath.workdps(30):
        A = mpmath.matrix([[-1, 1, 0], [0, -1, 1], [0, 0, -1]])
        B, unit = mpmath.matrix([0, 0, 4]), mpmath.eye(3)

        def start(h):
            E = mpmath.expm(A * h)
            return -mpmath.inverse(unit + E) * mpmath.inverse(A) * (E - unit) * B

        h = mpmath.findroot(lambda h: start(h)[0], mpmath.pi / mpmath.sqrt(3))
        begin = start(h)

        def state(t):
            E = mpmath.expm(A * t)
            return E * begin + mpmath.inverse(A) * (E - unit) * B

        turn = mpmath.findroot(lambda t: state(t)[1] - state(t)[0], h / 2)
        return {
            "period": float(2 * h),
            "amplitude": float(abs(state(turn)[0])),
            "predicted period": float(2 * mpmath.pi / mpmath.sqrt(3)),
            "predicted amplitude": float(2 / mpmath.pi),
        }


def three_elements() -> dict[str, float]:
    """Motor and load with gap, friction and saturation: followed until the cycle repeats."""

    def demand(y: np.ndarray) -> float:
        return -0.05 * y[2] - 1.5 * y[1] + y[5]

    def control(t: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.array([limited(demand(y), 0.4), 0.0]), np.array([-20.0 * y[1]])

    machine = Machine(
        np.diag([2e-4, 5e-4]),
        np.diag([0.0, 4e-3]),
        np.zeros((2, 2)),
        lambda t: np.zeros(2),
        (Contact([-1.0, 1.0], 80.0, 0.0, -0.01, 0.01),),
        (Friction([1.0, 0.0], lambda u: 0.04, 0.07),),
        control=control,
        corners=[lambda t, y, side=side: demand(y) - side * 0.4 for side in (1, -1)],
        kept=1,
    )
    y, modes = np.array([0.3, 0.3, 0.0, 0.0, 0.0, 0.0]), None
    for number in range(160):
        flight = machine.fly(0.1 * number, y, 0.1 * (number + 1), modes, rtol=1e-9)
        y, modes = flight.state, flight.modes
    flight = Flight()
    for number in range(160, 180):
        part = machine.fly(0.1 * number, y, 0.1 * (number + 1), modes)
        flight.pieces.extend(part.pieces)
        y, modes = part.state, part.modes
    begin, _, end = flight.passes(lambda y: float(y[1]), 0.0)[-3:]
    cycle = flight.between(begin, end)
    return {
        "period": end - begin,
        "amplitude of the load": 0.5 * cycle.peak_to_peak(lambda t, y: y[1]),
        "amplitude of the motor": 0.5 * cycle.peak_to_peak(lambda t, y: y[0]),
    }
