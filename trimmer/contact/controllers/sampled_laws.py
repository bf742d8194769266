"""Sampled control laws: what is demanded at a sample, and what is kept until the next one.

With e = r - y and T the sample, as ``docs/mechanism.md`` has them: the integral and the filter of the rate by
the backward rule, a transfer function by Tustin's (Åström and Wittenmark, Computer-Controlled Systems, 8).
"""

from functools import singledispatch
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Reals
from trimmer.mechanism.controls.controllers import DIFFERENCE, Cascade, Controller, Pid, TransferController

INPUTS = ("y", "r", "r'", "v")
"""What is measured and given at a sample, behind the states: output, reference, its rate, and speed."""

BEFORE = "y before"  # The state that is the output at the last sample


class SampledLaw(NamedTuple):
    """A sampled law of s states and the inputs."""

    states: tuple[str, ...]  # What the states are
    demand: Reals  # w, before the limit, (s + 4,)
    keep: Reals  # The states afterwards, if no limit is reached, (s, s + 4)
    follow: Reals  # How the states follow what acts less what was demanded, (s,)


def _units(states: tuple[str, ...]) -> dict[str, Reals]:
    names = (*states, *INPUTS)
    return dict(zip(names, np.eye(len(names)), strict=True))


@singledispatch
def law_of(controller: Controller) -> SampledLaw:
    """Return the law of a sampled controller."""
    raise AssertionError("every kind of controller has a law")


@law_of.register
def _(controller: Pid) -> SampledLaw:
    states = ("I",) * controller.integrates + ("z",) * (controller.kd != 0)
    of, sample = _units(states), float(controller.sample or 0.0)
    error, keep = of["r"] - of["y"], dict[str, Reals]()
    demand = controller.kp * error
    if "z" in states:
        keep["z"] = of["z"] + sample / (controller.filter_time + sample) * (error - of["z"])
        demand = demand + controller.kd / controller.filter_time * (error - keep["z"])
    if "I" in states:
        keep["I"] = of["I"] + controller.ki * sample * error
        demand = demand + keep["I"]
    return _law(controller, states, demand, keep)


@law_of.register
def _(controller: Cascade) -> SampledLaw:
    differs = controller.speed == DIFFERENCE
    states = ("I",) * controller.integrates + (BEFORE,) * differs
    of, sample = _units(states), float(controller.sample or 0.0)
    speed, keep = of["v"], dict[str, Reals]()
    if differs:
        keep[BEFORE] = of["y"]
        speed = speed + (of["y"] - of[BEFORE]) / sample
    slow = controller.kp * (of["r"] - of["y"]) + controller.feedforward * of["r'"] - speed
    demand = controller.kv * slow
    if controller.ti is not None:
        keep["I"] = of["I"] + controller.kv / controller.ti * sample * slow
        demand = demand + keep["I"]
    return _law(controller, states, demand, keep)


@law_of.register
def _(controller: TransferController) -> SampledLaw:
    half = 0.5 * float(controller.sample or 0.0)
    leading = controller.denominator[0]
    below = np.array(controller.denominator[1:]) / leading
    order = len(below)
    above = np.zeros(order + 1)
    given = np.trim_zeros(controller.numerator, "f")
    above[order + 1 - len(given) :] = np.array(given) / leading
    states = tuple(f"x{number}" for number in range(1, order + 1))
    of = _units(states)
    error = of["r"] - of["y"]
    flow, push = np.eye(order, k=-1), np.eye(order, 1)[:, 0]
    flow[:1] = -below
    read = above[1:] - above[0] * below
    nearer, farther = np.eye(order) - half * flow, np.eye(order) + half * flow
    pushed, seen = np.linalg.solve(nearer, push), np.linalg.solve(nearer.T, read)
    every = np.array([of[name] for name in states]).reshape(order, order + len(INPUTS))
    keep = np.linalg.solve(nearer, farther) @ every + 2.0 * half * np.outer(pushed, error)
    demand = seen @ every + (above[0] + half * float(read @ pushed)) * error
    return _law(controller, states, demand, dict(zip(states, keep, strict=True)))


def _law(
    controller: Controller, states: tuple[str, ...], demand: Reals, keep: dict[str, Reals]
) -> SampledLaw:
    time, sample = controller.tracking_time, float(controller.sample or 0.0)
    follow = [sample / time if name == "I" and time is not None else 0.0 for name in states]
    rows = np.array([keep[name] for name in states]).reshape(len(states), len(demand))
    return SampledLaw(states, demand, rows, np.array(follow))
