"""Sampled controllers from their definition: numbers in a loop, a list of what is on its way."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from trimmer.mechanism import Cascade, Controller, Pid, TransferController


@dataclass
class SampledControl:
    """One controller: what it remembers, and what is on its way as times and values."""

    controller: Controller
    integral: float = 0.0
    filtered: float = 0.0
    before: float | None = None
    errors: list[float] = field(default_factory=list)
    demands: list[float] = field(default_factory=list)
    on_its_way: list[tuple[float, float]] = field(default_factory=list)
    acting: float = 0.0

    def sample(self, time: float, y: float, given: tuple[float, float], speed: float) -> float:
        """Sample, and return what will act."""
        law, step = self.controller, self.controller.sample
        error = given[0] - y
        if isinstance(law, Pid):
            rate = 0.0
            if law.kd:
                self.filtered += step / (law.filter_time + step) * (error - self.filtered)
                rate = law.kd * (error - self.filtered) / law.filter_time
            slope = law.ki * error
            demand = law.kp * error + self.integral + step * slope + rate
        elif isinstance(law, Cascade):
            if law.speed == "difference":
                speed, self.before = (0.0 if self.before is None else (y - self.before) / step), y
            slower = law.kp * error + law.feedforward * given[1] - speed
            slope = law.kv / law.ti * slower if law.ti else 0.0
            demand = law.kv * slower + self.integral + step * slope
        else:
            slope, demand = 0.0, self._by_tustin(law, error)
        acts = demand if law.limit is None else min(max(demand, -law.limit), law.limit)
        self.integral += step * slope
        if law.limit is not None and law.integrates:
            self.integral += step / law.tracking_time * (acts - demand)
        self.on_its_way.append((time + law.delay, acts))
        return acts

    def _by_tustin(self, law: TransferController, error: float) -> float:
        """The difference equation: s = 2 (q - 1) / (T (q + 1)), times (q + 1)^n, with q the shift."""
        order = len(law.denominator) - 1
        above, below = (self._shifted(each, order) for each in (law.numerator, law.denominator))
        self.errors, self.demands = [error, *self.errors], [0.0, *self.demands]
        past = [each + [0.0] * (order + 1) for each in (self.errors, self.demands)]
        total = sum(b * e for b, e in zip(above, past[0], strict=False))
        total -= sum(a * w for a, w in zip(below[1:], past[1][1:], strict=False))
        self.demands[0] = total / below[0]
        return self.demands[0]

    def _shifted(self, coefficients: tuple[float, ...], order: int) -> np.ndarray:
        total = np.zeros(order + 1)
        for power, each in enumerate(reversed(coefficients)):
            s = np.array([1.0])
            for number in range(order):
                s = np.polymul(
                    s,
                    [2 / self.controller.sample, -2 / self.controller.sample]
                    if number < power
                    else [1.0, 1.0],
                )
            total += each * s
        return total

    def act(self, time: float) -> None:
        """Let what is due act."""
        near = 1e-9 * self.controller.sample
        due = [each for each in self.on_its_way if each[0] <= time + near]
        if due:
            self.acting = due[-1][1]
        self.on_its_way = self.on_its_way[len(due) :]


def instants(controls: list[SampledControl], end: float) -> Iterator[tuple[float, list[bool]]]:
    """Yield each instant before the end at which something is sampled or acts, and who samples."""
    found: dict[int, list[float]] = {}
    times: list[float] = []
    for number, each in enumerate(controls):
        law = each.controller
        samples = [k * law.sample for k in range(math.ceil(end / law.sample - 1e-9))]
        found[number] = samples
        times += samples + [time + law.delay for time in samples]
    near = 1e-9 * min(each.controller.sample for each in controls)
    last = -math.inf
    for time in sorted(times):
        if last + near < time < end - near:
            yield time, [any(abs(time - each) <= near for each in found[n]) for n in range(len(controls))]
            last = time
