"""Random loops, and the stable periodic motions that brute force finds in them."""

import math
from dataclasses import dataclass

import control
import numpy as np
import scipy.signal

from trimmer import ClosedLoop, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash, simulate
from trimmer.elements import Element
from trimmer.loops import Outcome

STARTS = 20
DURATION = 300.0  # In units of the time constants, which are about one


@dataclass(frozen=True)
class RandomLoop:
    system: control.StateSpace
    element: Element
    generator: np.random.Generator


def random_loop(number: int) -> RandomLoop:
    """Draw poles and zeros between 0.2 and 5 rad/s, some unstable, and a gain of either sign."""
    generator = np.random.default_rng(1000 + number)
    order = 2 + number % 4
    zeros = int(generator.integers(0, order))
    poles = roots(generator, order, 0.1)
    if generator.random() < 0.3:
        poles[-1] = poles[-1] if poles[-1].imag else 0.0
    numerator = np.real(np.poly(roots(generator, zeros, 0.15)))
    gain = 10.0 ** generator.uniform(0.0, 2.0) * (-1.0 if generator.random() < 0.25 else 1.0)
    elements = (
        Relay(10.0 ** generator.uniform(-1.0, 1.0)),
        FrictionBacklash(10.0 ** generator.uniform(-1.0, 1.0)),
        InertiaBacklash(10.0 ** generator.uniform(-1.0, 1.0)),
        ViscousBacklash(10.0 ** generator.uniform(-1.0, 1.0), 10.0 ** generator.uniform(-1.5, 1.5)),
    )
    matrices = scipy.signal.tf2ss(gain * np.atleast_1d(numerator), np.real(np.poly(poles)))
    return RandomLoop(control.ss(*matrices), elements[(number // 4) % 4], generator)


def mixed_states(system: control.StateSpace, seed: int) -> control.StateSpace:
    """The same system in states that each mix all of its own ones, with a condition of 10 at most."""
    generator, order = np.random.default_rng(seed), system.nstates
    left, right = (np.linalg.qr(generator.normal(size=(order, order)))[0] for _ in range(2))
    turn = left @ np.diag(10.0 ** generator.uniform(-0.5, 0.5, order)) @ right
    return control.ss(
        np.linalg.solve(turn, system.A @ turn), np.linalg.solve(turn, system.B), system.C @ turn, 0
    )


def roots(generator: np.random.Generator, count: int, unstable: float) -> np.ndarray:
    """Draw roots in conjugate pairs, and a real one if their number is odd or chance wills."""
    found: list[complex] = []
    while len(found) < count:
        rate = 10.0 ** generator.uniform(-0.7, 0.7)
        sign = 1.0 if generator.random() < unstable else -1.0
        if count - len(found) >= 2 and generator.random() < 0.6:
            damping = 10.0 ** generator.uniform(-1.7, -0.1)
            root = rate * complex(sign * damping, math.sqrt(1.0 - damping**2))
            found += [root, root.conjugate()]
        else:
            found.append(complex(sign * rate))
    return np.array(found)


def stable_amplitudes(loop: RandomLoop) -> list[float]:
    """Return the amplitudes of the periodic motions that long simulations from random states end in."""
    order, found = loop.system.nstates, []
    for _ in range(STARTS):
        start = loop.generator.normal(size=order) * 10.0 ** loop.generator.uniform(-1.0, 1.5)
        amplitude = final_amplitude(loop, start)
        if amplitude is not None and all(abs(amplitude / other - 1) > 1e-3 for other in found):
            found.append(amplitude)
    return found


def final_amplitude(loop: RandomLoop, start: np.ndarray) -> float | None:
    """Return half of peak to peak of a motion that repeats itself at its end; None if it does not."""
    motion = simulate(
        ClosedLoop(loop.system, loop.element),
        DURATION,
        initial_state=start,
        event_limit=50_000,
        step_limit=10**6,
    )
    log = motion.log
    if motion.outcome is not Outcome.COMPLETED or len(log.start) < 40:
        return None
    order, last = loop.system.nstates, len(log.start) - 2
    alike = np.flatnonzero((log.mode[:last] == log.mode[last]) & (log.start[:last] > 0.5 * DURATION))
    size = abs(log.state[-40:, :order]).max(axis=0)
    differences = (abs(log.state[alike, :order] - log.state[last, :order]) / size).max(axis=1)
    elapsed = log.start[last] - log.start[alike]
    back = alike[(differences < 1e-7) & (elapsed > 0)]
    # It has to come back more than once, and not shrink: a spiral into a point comes back nowhere.
    if len(back) < 3:
        return None
    begin, end = log.start[back[-1]], log.start[last]
    values = motion.element_input(np.linspace(begin, end, 20_001))
    return float(np.ptp(values)) / 2
