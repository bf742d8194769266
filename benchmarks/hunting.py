"""A servo with backlash and stick that hunts, beside SciPy's `solve_ivp`; a sampled axis; cells of a map.

Run it with `python -m benchmarks.hunting`. The peer follows `examples/two-mass-servo.toml` through its step
with DOP853 at 1e-8, contacts and stick by terminal events. Absolute targets hold where the calibration loop
takes what is its reference.
"""

import argparse
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.arrays import Reals
from trimmer.maps.cell_motion import described
from trimmer.maps.motion_map import motion_map
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.simulation.simulate import simulate
from trimmer.runners.runner import SerialRunner

EXAMPLES = Path(__file__).parents[1] / "examples"
SERVO = Mechanism.from_toml(EXAMPLES / "two-mass-servo.toml")
AXIS = Mechanism.from_toml(EXAMPLES / "sampled-axis.toml")
DURATION, ROUNDS, CELLS = 2.0, 5, 8
MOTOR, LOAD, STIFFNESS, DAMPING, GAP, GUIDE = 2e-4, 5e-4, 80.0, 0.02, np.radians(0.2), 2e-3
KINETIC, STATIC, KP, KV, TI, LIMIT = 5e-3, 7.5e-3, 40.0, 0.1, 0.01, 2.0
STEP, AT = np.radians(30.0), 0.01
RATIO, SECOND, CELL = 100, 30e-3, 48e-3
"""Targets: ratio to the peer; a second of a sampled axis, s; processor time of a cell, s, 60 s for 2 500."""


class Peer:
    """The servo as its equations are by hand: two angles, two speeds, integral, stretch of the pad."""

    def __init__(self) -> None:
        self.side, self.slips, self.reference = 0, 0, 0.0

    def pull(self, state: Reals) -> float:
        """Return the force of the gear."""
        beyond, speed = state[0] - state[1] - self.side * GAP / 2, state[2] - state[3]
        return float(STIFFNESS * beyond + DAMPING * speed) if self.side else 0.0

    def control(self, state: Reals) -> tuple[float, float]:
        """Return the demand, and the rate of its proportional part that is integrated."""
        follow = KP * (self.reference - state[1]) - state[2]
        return KV * follow + state[4], KV / TI * follow

    def rates(self, moment: float, state: Reals) -> list[float]:
        """Return the rates of the states."""
        demand, integrated = self.control(state)
        torque, pull = min(max(demand, -LIMIT), LIMIT), self.pull(state)
        motor = (torque - pull - self.slips * KINETIC) / MOTOR if self.slips else 0.0
        pad = state[2] - state[3] if self.side else -STIFFNESS / DAMPING * state[5]
        integral = integrated + (torque - demand) / TI
        return [state[2], state[3], motor, (pull - GUIDE * state[3]) / LOAD, integral, pad]

    def events(self) -> list[Callable[[float, Reals], float]]:
        """Return what ends a smooth piece."""
        found: list[Callable[[float, Reals], float]] = []
        if self.side:
            found.append(lambda t, x: self.side * self.pull(x))
        else:
            found.append(lambda t, x: GAP / 2 + x[5] - (x[0] - x[1]))
            found.append(lambda t, x: x[0] - x[1] + GAP / 2 - x[5])
        if self.slips:
            found.append(lambda t, x: self.slips * x[2])
        else:
            found.append(lambda t, x: STATIC - abs(self.load(x)))
        for each in found:
            each.terminal, each.direction = True, -1  # type: ignore[attr-defined]
        return found

    def load(self, state: Reals) -> float:
        """Return what friction bears while the motor sticks."""
        return min(max(self.control(state)[0], -LIMIT), LIMIT) - self.pull(state)

    def follows(self, state: Reals, event: int) -> None:
        """Go on to the mode that follows an event."""
        contacts = 1 if self.side else 2
        if event < contacts:
            self.side = 0 if self.side else (1, -1)[event]
            state[5] = state[0] - state[1] - self.side * GAP / 2 if self.side else state[5]
        elif not self.slips:
            self.slips = 1 if self.load(state) > 0 else -1
        else:
            state[2], load = 0.0, self.load(state)
            self.slips = 0 if abs(load) <= STATIC else 1 if load > 0 else -1

    def final(self) -> Reals:
        """Return the state after the motion."""
        moment, state = 0.0, np.zeros(6)
        while moment < DURATION:
            until = AT if moment < AT else DURATION
            options = {"method": "DOP853", "rtol": 1e-8, "atol": 1e-12, "events": self.events()}
            ended = solve_ivp(self.rates, (moment, until), state, **options)
            moment, state = float(ended.t[-1]), ended.y[:, -1].copy()
            if ended.status == 0:
                self.reference = STEP
                if not self.slips and abs(self.load(state)) > STATIC:
                    self.slips = 1
            else:
                self.follows(state, next(at for at, each in enumerate(ended.t_events) if each.size))
        return state


def seconds(function: Callable[[], object]) -> float:
    """Return the shortest time of some calls, s."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def cells(count: int) -> tuple[float, Counter[str]]:
    """Return the processor time of a cell over gap and gain, s, and what was found."""
    values = {
        "plays.gear.gap": np.radians(np.linspace(0.02, 0.5, count)),
        "controllers.axis.kp": np.linspace(5.0, 60.0, count),
    }
    start = time.process_time()
    found = motion_map(SERVO, values, runner=SerialRunner(), quiet=True)
    spent = time.process_time() - start
    return spent / count**2, Counter(described(each.motions[0]) for each in found.cells)


def main() -> None:
    """Print times beside their targets, and how far both motions are apart."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, default=CELLS, help="cells of each side (default: %(default)s)")
    asked = parser.parse_args()
    print(sentence())
    own = simulate(SERVO, DURATION)
    theirs, ours = seconds(lambda: Peer().final()), seconds(lambda: simulate(SERVO, DURATION))
    apart = abs(Peer().final()[:4] - own.course.end.state[:4]).max()
    print(f"servo, {DURATION:g} s, {len(own.events)} events: {1e3 * ours:.2f} ms")
    print(f"  solve_ivp {1e3 * theirs:.0f} ms, ratio {theirs / ours:.0f} (target {RATIO})")
    print(f"  ends {apart:.1g} apart")
    sampled = seconds(lambda: simulate(AXIS, 1.0))
    print(f"a second at 1 kHz: {1e3 * sampled:.2f} ms (target {1e3 * SECOND:g})")
    cells(2)  # compiles, or reads what was compiled
    spent, kinds = cells(asked.cells)
    print(f"a cell over gap and gain: {1e3 * spent:.1f} ms of processor time (target {1e3 * CELL:g})")
    print(", ".join(f"{name} {number / asked.cells**2:.1%}" for name, number in kinds.most_common()))
    print(sentence())


if __name__ == "__main__":
    main()
