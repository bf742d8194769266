"""The laws of continuous controllers as linear systems; what is measured and what acts is put in elsewhere.

With x the states of a controller, e the error, v the speed, r' the rate of the reference and w the demand:

    x' = A x + b_e e + b_v v + b_r r' + t (sat(w) - w)
    w = c x + d_e e + d_v v + d_r r'

A Padé approximant of the delay has states of its own: p' = A p + b sat(w), and c p + d sat(w) acts.
"""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.mechanism import Cascade, Controller, Mechanism, Pid, TransferController

ERROR, SPEED, RATE = range(3)  # What goes into a law


@dataclass(frozen=True, eq=False)
class Linear:
    """x' = state x + given u, y = read x + through u, with n states and m inputs."""

    names: tuple[str, ...]  # What the states are
    state: Reals  # (n, n)
    given: Reals  # (n, m)
    read: Reals  # (n,)
    through: Reals  # (m,)


@dataclass(frozen=True, eq=False)
class Law:
    """A continuous controller."""

    demand: Linear  # From error, speed and rate of the reference to what is demanded
    tracking: Reals  # What follows the limit: t above, (n,)
    acting: Linear  # From what is left of that by the limit to what acts: the delay, or nothing

    @property
    def names(self) -> tuple[str, ...]:
        """What its states are."""
        return (*self.demand.names, *self.acting.names)


def laws_of(mechanism: Mechanism) -> dict[str, Law]:
    """Return the law of each continuous controller, by name."""
    controllers = mechanism.controllers.items()
    return {name: law_of(controller) for name, controller in controllers if controller.sample is None}


def law_of(controller: Controller) -> Law:
    """Return the law of a continuous controller."""
    demand = _demand(controller)
    tracking = np.zeros(len(demand.names))
    if controller.tracking_time is not None:
        tracking[demand.names.index("integral")] = 1.0 / controller.tracking_time
    order = controller.pade if controller.delay else None
    acting = _NOTHING if order is None else realized(*_pade(order, controller.delay), "delay")
    return Law(demand, tracking, acting)


_NOTHING = Linear((), np.zeros((0, 0)), np.zeros((0, 1)), np.zeros(0), np.ones(1))


def _demand(controller: Controller) -> Linear:
    match controller:
        case Pid():
            return _of_pid(controller)
        case Cascade():
            return _of_cascade(controller)
        case TransferController():
            found = realized(controller.numerator, controller.denominator, "state")
            given = np.zeros((len(found.names), 3))
            given[:, ERROR] = found.given[:, 0]
            return Linear(found.names, found.state, given, found.read, found.through[0] * np.eye(3)[ERROR])
    raise TypeError(f"unknown controller {controller!r}")


def _of_pid(pid: Pid) -> Linear:
    names = [name for name, gain in (("integral", pid.ki), ("filter", pid.kd)) if gain]
    state, given = np.zeros((len(names), len(names))), np.zeros((len(names), 3))
    read, through = np.zeros(len(names)), pid.kp * np.eye(3)[ERROR]
    if pid.ki:
        given[0, ERROR], read[0] = pid.ki, 1.0
    if pid.kd:
        state[-1, -1], given[-1, ERROR] = -1.0 / pid.filter_time, 1.0 / pid.filter_time
        read[-1] = -pid.kd / pid.filter_time
        through[ERROR] += pid.kd / pid.filter_time
    return Linear(tuple(names), state, given, read, through)


def _of_cascade(cascade: Cascade) -> Linear:
    slip = np.array([cascade.kp, -1.0, cascade.feedforward])
    names = () if cascade.ti is None else ("integral",)
    given = np.array([cascade.kv / ti * slip for ti in (cascade.ti,) if ti is not None]).reshape(-1, 3)
    return Linear(names, np.zeros((len(names),) * 2), given, np.ones(len(names)), cascade.kv * slip)


def realized(numerator: tuple[float, ...], denominator: tuple[float, ...], name: str) -> Linear:
    """Return a proper transfer function as a system, in a time in which its poles are about 1."""
    below = np.array(denominator) / denominator[0]
    order = len(below) - 1
    above = np.zeros(order + 1)
    above[order + 1 - min(len(numerator), order + 1) :] = np.array(numerator[-(order + 1) :]) / denominator[0]
    last = int(np.flatnonzero(below)[-1])
    rate = abs(below[last]) ** (1.0 / last) if last else 1.0
    scale = rate ** -np.arange(order + 1)
    below, above = below * scale, above * scale
    through = above[0]
    state = rate * np.eye(order, k=-1)
    state[:1] = -rate * below[1:]
    given = np.zeros((order, 1))
    given[:1] = rate
    names = tuple(f"{name} {number}" for number in range(1, order + 1))
    return Linear(names, state, given, above[1:] - through * below[1:], np.array([through]))


def _pade(order: int, delay: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the (n, n) Padé approximant of exp(-s delay)."""
    ratios = [
        math.factorial(2 * order - power)
        * math.factorial(order)
        / (math.factorial(2 * order) * math.factorial(power) * math.factorial(order - power))
        * delay**power
        for power in range(order, -1, -1)
    ]
    signs = [(-1.0) ** power for power in range(order, -1, -1)]
    return tuple(sign * each for sign, each in zip(signs, ratios, strict=True)), tuple(ratios)
