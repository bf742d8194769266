"""Motions by SciPy's `solve_ivp` with terminal events, written from the laws of the elements alone."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import solve_ivp

from trimmer.arrays import Reals

Signal = Callable[[float, Reals], float]

TOLERANCES = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-13, "max_step": 0.05}


@dataclass(frozen=True)
class Plant:
    """x' = A x + B v in feedback u = -C x, or with u = amplitude sin(omega t + phase)."""

    A: Reals
    B: Reals
    C: Reals
    drive: tuple[float, float, float] | None = None

    def input(self, time: float, x: Reals) -> float:
        if self.drive is None:
            return -float(self.C @ x)
        amplitude, omega, phase = self.drive
        return amplitude * math.sin(omega * time + phase)

    def input_rate(self, time: float, x: Reals, output: float) -> float:
        if self.drive is None:
            return -float(self.C @ (self.A @ x + self.B * output))
        amplitude, omega, phase = self.drive
        return amplitude * omega * math.cos(omega * time + phase)

    def input_curvature(self, time: float, x: Reals, output: float, output_rate: float) -> float:
        if self.drive is None:
            return -float(self.C @ (self.A @ (self.A @ x + self.B * output) + self.B * output_rate))
        amplitude, omega, phase = self.drive
        return -amplitude * omega**2 * math.sin(omega * time + phase)


@dataclass
class Course:
    """What a peer found: times of events, and the state on request."""

    events: list[float] = field(default_factory=list)
    pieces: list[tuple[float, float, Callable[[float], Reals]]] = field(default_factory=list)

    def state(self, time: float, count: int) -> Reals:
        dense = next(dense for begin, end, dense in reversed(self.pieces) if begin <= time <= end)
        return np.asarray(dense(time))[:count]


def _until(
    course: Course,
    rates: Callable[[float, Reals], Reals],
    begin: float,
    start: Reals,
    end: float,
    *event_functions: Signal,
) -> tuple[float, Reals, int]:
    """Follow a mode until an event function falls through zero; return time, state, and which (-1: none)."""

    def terminal(event_function: Signal) -> Signal:
        def event(time: float, state: Reals) -> float:
            return event_function(time, state)

        event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
        return event

    part = solve_ivp(
        rates,
        (begin, end),
        start,
        events=[terminal(event_function) for event_function in event_functions],
        dense_output=True,
        **TOLERANCES,
    )
    course.pieces.append((begin, part.t[-1], part.sol))
    if part.status != 1:
        return end, part.y[:, -1], -1
    course.events.append(float(part.t[-1]))
    fired = next(k for k, times in enumerate(part.t_events) if times.size)
    return float(part.t[-1]), part.y[:, -1], fired


def play(plant: Plant, gap: float, tau: float, start: Reals, end: float) -> Course:
    """Follow a plant behind a load M v' + D v = 0 with play, tau = M/D, 0 to infinity, at rest at 0."""
    course, n = Course(), len(plant.A)
    time, state, side = 0.0, np.append(start, [0.0, 0.0]), 0

    def position(t: float, z: Reals) -> float:
        return plant.input(t, z[:n]) - side * gap / 2 if side else float(z[n])

    def rates(t: float, z: Reals) -> Reals:
        slowing = 0.0 if side or tau in (0.0, math.inf) else -z[n + 1] / tau
        speed = 0.0 if side else z[n + 1]
        return np.concatenate([plant.A @ z[:n] + plant.B * position(t, z), [speed, slowing]])

    def force(t: float, z: Reals) -> float:
        output = position(t, z)
        rate = plant.input_rate(t, z[:n], output)
        curvature = plant.input_curvature(t, z[:n], output, rate)
        return side * (curvature if math.isinf(tau) else tau * curvature + rate)

    while time < end:
        if side == 0:
            time, state, fired = _until(
                course,
                rates,
                *(time, state, end),
                lambda t, z: gap / 2 - plant.input(t, z[:n]) + z[n],
                lambda t, z: gap / 2 + plant.input(t, z[:n]) - z[n],
            )
            side = (1, -1)[fired] if fired >= 0 else 0
            if side and force(time, state) > 0:
                continue
        else:
            time, state, fired = _until(course, rates, time, state, end, force)
        if side and time < end:
            state[n] = position(time, state)
            state[n + 1] = plant.input_rate(time, state[:n], state[n]) if tau > 0 else 0.0
            side = 0
    return course


def switch(plant: Plant, level: float, of_rate: bool, start: Reals, end: float) -> Course:
    """Follow a plant behind level * sign(u), or level * sign(u'), with sliding or stick where it holds."""
    course = Course()
    acts = float(plant.C @ (plant.A @ plant.B if of_rate else plant.B)) if plant.drive is None else 0.0

    def rates_with(output: Signal) -> Callable[[float, Reals], Reals]:
        return lambda t, x: plant.A @ x + plant.B * output(t, x)

    def switching(t: float, x: Reals) -> float:
        return plant.input_rate(t, x, 0.0) if of_rate else plant.input(t, x)

    def holding(t: float, x: Reals) -> float:
        """Return the output that keeps the switching function: its rate is linear in the output."""
        row = plant.C @ plant.A if of_rate else plant.C
        return -float(row @ (plant.A @ x)) / acts

    time, x = 0.0, start
    sign = math.copysign(1.0, switching(time, x))
    while time < end:
        time, x, fired = _until(
            course,
            rates_with(lambda _t, _x, sign=sign: sign * level),
            *(time, x, end),
            lambda t, x, sign=sign: sign * switching(t, x),
        )
        if fired < 0:
            break
        if acts > 0 and abs(holding(time, x)) < level:
            time, x, fired = _until(
                course,
                rates_with(holding),
                *(time, x, end),
                lambda t, x: level - holding(t, x),
                lambda t, x: level + holding(t, x),
            )
            sign = 1.0 if fired == 0 else -1.0
        else:
            sign = -sign
    return course


def pieces(
    plant: Plant,
    limits: tuple[float, ...],
    laws: tuple[Callable[[float], float], ...],
    hysteresis: float,
    start: Reals,
    end: float,
) -> Course:
    """Follow a plant behind an element whose input alone says its output between limits, which may lag."""
    course, time, x = Course(), 0.0, start
    piece = int(np.searchsorted(limits, plant.input(time, x)))
    while time < end:
        above = [(1, limit + hysteresis) for limit in limits[piece : piece + 1]]
        exits = above + [(-1, limit - hysteresis) for limit in limits[max(piece - 1, 0) : piece]]
        time, x, fired = _until(
            course,
            lambda t, x, law=laws[piece]: plant.A @ x + plant.B * law(plant.input(t, x)),
            *(time, x, end),
            *(lambda t, x, up=up, limit=limit: up * (limit - plant.input(t, x)) for up, limit in exits),
        )
        piece += exits[fired][0] if fired >= 0 else 0
    return course
