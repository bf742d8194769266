"""Loops by small fixed steps, in compiled plain Python; only the numbers of an element come from trimmer.

A step predicts the element's output at its end and moves the plant under the mean of both outputs, twice. A
load flies on freely and is then clamped to the gap, where it takes the speed of the pin (time-stepping after
Moreau); a relay that switches within a step acts with the mean of both signs, weighted at the crossing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numba
import numpy as np
from scipy.linalg import expm

from trimmer.elements import Element, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash

GROWN = 1e9
STEADY = 2e-4
"""Change of the extremes over the last half of the time, over the swing, below which a motion is periodic."""
SMALLEST = 0.1  # Of the gap


@dataclass(frozen=True)
class PeerLoop:
    """x' = A x + B f(-C x), with a relay of a level, or a load in a gap with a time constant M/D."""

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    level: float = 0.0
    gap: float = 0.0
    time_constant: float = 0.0

    @classmethod
    def of(cls, A: np.ndarray, B: np.ndarray, C: np.ndarray, element: Element) -> PeerLoop:
        matrices = np.ascontiguousarray(A), np.ascontiguousarray(B).ravel(), np.ascontiguousarray(C).ravel()
        match element:
            case Relay():
                return cls(*matrices, level=element.level)
            case FrictionBacklash():
                return cls(*matrices, gap=element.gap)
            case InertiaBacklash():
                return cls(*matrices, gap=element.gap, time_constant=math.inf)
            case ViscousBacklash():
                return cls(*matrices, gap=element.gap, time_constant=element.time_constant)
        raise TypeError(element)

    def inputs(self, start: np.ndarray, step: float, steps: int) -> np.ndarray:
        """Return the element's input after each step from a state of the plant; the load rests at the pin."""
        order = len(self.A)
        block = np.zeros((order + 1, order + 1))
        block[:order, :order], block[:order, order] = self.A * step, self.B * step
        both = expm(block)
        share = 0.0 if self.time_constant == 0.0 else math.exp(-step / self.time_constant)
        flown = (
            step
            if share == 1.0
            else -self.time_constant * math.expm1(-step / self.time_constant)
            if share
            else 0.0
        )
        advance, push = np.ascontiguousarray(both[:order, :order]), both[:order, order].copy()
        rates = np.ascontiguousarray(-self.C @ self.A), float(-self.C @ self.B)
        return _inputs(advance, push, self.C, *rates, self.level, 0.5 * self.gap, share, flown, start, steps)


@numba.njit
def _inputs(advance, push, C, rate_row, rate_gain, level, half_gap, share, flown, start, steps):
    order = start.size
    state, base, inputs = start.copy(), np.empty(order), np.empty(steps)
    pin = -(C @ state)
    load, speed, pushed = pin, 0.0, C @ push
    for k in range(steps):
        outlet = 0.0
        for i in range(order):
            base[i] = 0.0
            for j in range(order):
                base[i] += advance[i, j] * state[j]
            outlet += C[i] * base[i]
        old = load if level == 0.0 else (level if pin > 0.0 else -level)
        mean = old
        free = load + speed * flown
        for _ in range(2):
            pin_next = -outlet - pushed * mean
            if level == 0.0:
                load_next = min(max(free, pin_next - half_gap), pin_next + half_gap)
                mean = 0.5 * (load + load_next)
            else:
                new = level if pin_next > 0.0 else -level
                where = pin / (pin - pin_next) if new != old else 1.0
                mean = old * where + new * (1.0 - where)
        pin = -outlet - pushed * mean
        pin_rate = rate_gain * load_next if level == 0.0 else 0.0
        for i in range(order):
            state[i] = base[i] + push[i] * mean
            pin_rate += rate_row[i] * state[i]
        if level == 0.0:
            speed = pin_rate if load_next != free else speed * share
            load = load_next
        inputs[k] = pin
        if not abs(pin) < GROWN:
            return inputs[: k + 1]
    return inputs


def final_amplitude(loop: PeerLoop, start: np.ndarray, step: float, duration: float) -> float | None:
    """Return half of peak to peak at the end; None if the motion grows, drifts, or is not or never periodic.

    A swing much smaller than the gap is that of the plant alone, which nothing sustains.
    """
    inputs = loop.inputs(start, step, int(duration / step))
    if not abs(inputs[-1]) < GROWN:
        return None
    windows = np.array_split(inputs[inputs.size // 2 :], 4)
    ends = np.array([(window.min(), window.max()) for window in windows])
    swing = 0.5 * float(np.ptp(windows[-1]))
    steady = np.ptp(ends, axis=0).max() <= STEADY * swing
    return swing if steady and swing > SMALLEST * loop.gap else None
