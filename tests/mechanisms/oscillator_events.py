"""One oscillator with one stop or one friction, event by event, to as many digits as are asked for.

``m x'' + c x' + k x = constant + P sin(omega t + phase)``, with a stop at ``gap`` or with dry friction on the
ground. Each phase is a sum of exponentials, each event a root of it: bracketed on a fine grid, then found
to all digits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import mpmath
from mpmath import mp, mpc, mpf

from trimmer import ContactLaw

GRID = 80


@dataclass(frozen=True)
class Oscillator:
    """Coefficients, as numbers that mpmath takes exactly."""

    mass: float
    damping: float
    stiffness: float
    amplitude: float
    omega: mpf
    phase: float = 0.0
    constant: float = 0.0

    def free(self, time: mpf, displacement: mpf, velocity: mpf) -> Exponentials:
        """Return the motion from a state on."""
        dynamic = mpc(self.stiffness - self.mass * self.omega**2, self.damping * self.omega)
        forced = self.amplitude * mpmath.expj(self.phase) / dynamic
        mean = mpf(self.constant) / self.stiffness
        turned = forced * mpmath.expj(self.omega * time)
        half = mpf(self.damping) / (2 * self.mass)
        root = mpmath.sqrt(mpc(half**2 - mpf(self.stiffness) / self.mass))
        first, second = -half + root, -half - root
        x, v = displacement - mean - turned.imag, velocity - (mpc(0, self.omega) * turned).imag
        a = (v - second * x) / (first - second)
        return Exponentials(time, mean, forced, self.omega, (first, second), (a, x - a))


@dataclass(frozen=True)
class Exponentials:
    """mean + Im(forced exp(i omega t)) + sum of weights exp(exponents (t - begin))."""

    begin: mpf
    mean: mpf
    forced: mpc
    omega: mpf
    exponents: tuple[mpc, mpc]
    weights: tuple[mpc, mpc]

    def __call__(self, time: mpf, order: int = 0) -> mpf:
        """Return the displacement or a derivative of it."""
        steady = (mpc(0, self.omega) ** order * self.forced * mpmath.expj(self.omega * time)).imag
        decaying = sum(
            weight * exponent**order * mpmath.exp(exponent * (time - self.begin))
            for weight, exponent in zip(self.weights, self.exponents, strict=True)
        )
        return (self.mean if order == 0 else 0) + steady + mpc(decaying).real


def first_negative(value: Callable[[mpf], mpf], begin: mpf, end: mpf, width: mpf) -> mpf | None:
    """Return when a function, positive just after ``begin``, turns negative; None if not before ``end``."""
    before, positive = begin, False
    while before < end:
        after = min(before + width, end)
        new = value(after)
        if new < 0 and (positive or value(before + (after - before) / 64) > 0):
            low = before if positive else before + (after - before) / 64
            return mpmath.findroot(value, (low, after), solver="anderson", tol=mp.eps**1.6, maxsteps=300)
        positive, before = new > 0, after
    return None


@dataclass(frozen=True)
class StopMotion:
    """Times at which the contact is made and broken, by turns, and the state at the end."""

    made: tuple[mpf, ...]
    broken: tuple[mpf, ...]
    displacement: mpf
    velocity: mpf


def with_stop(
    oscillator: Oscillator, stop: tuple[float, float, float], law: ContactLaw, start: tuple, end: mpf
) -> StopMotion:
    """Move an oscillator that begins free and relaxed.

    Args:
        oscillator: Without the stop.
        stop: Stiffness, damping and gap of the stop.
        law: What it does when it would have to pull; a truncated one must not push again beyond the gap.
        start: Displacement and velocity at time 0.
        end: The last time.
    """
    k, c, gap = (mpf(number) for number in stop)
    closed = replace(
        oscillator,
        stiffness=mpf(oscillator.stiffness) + k,
        damping=mpf(oscillator.damping) + c,
        constant=mpf(oscillator.constant) + k * gap,
    )
    width = 2 * mp.pi / oscillator.omega / GRID
    time, state, left = mpf(0), (mpf(start[0]), mpf(start[1])), mpf(0)
    made, broken = [], []
    while True:
        free = oscillator.free(time, *state)

        def clearance(t, free=free, left=left, time=time):
            z = left * mpmath.exp(-k / c * (t - time)) if law is ContactLaw.RELAXING and c else 0
            return gap - free(t) + z

        time = first_negative(clearance, time, end, width)
        if time is None:
            return StopMotion(tuple(made), tuple(broken), free(end), free(end, 1))
        made.append(time)
        touching = closed.free(time, free(time), free(time, 1))

        def held(t, touching=touching):
            beyond = touching(t) - gap
            return beyond if law is ContactLaw.PULLING else k * beyond + c * touching(t, 1)

        time = first_negative(held, time, end, width)
        if time is None:
            return StopMotion(tuple(made), tuple(broken), touching(end), touching(end, 1))
        broken.append(time)
        state = (touching(time), touching(time, 1))
        left = state[0] - gap
        if law is ContactLaw.TRUNCATED and c:
            leaving = oscillator.free(time, *state)
            time = first_negative(lambda t, leaving=leaving: leaving(t) - gap, time, end, width)
            state = (leaving(time), leaving(time, 1))


@dataclass(frozen=True)
class FrictionMotion:
    """Times at which sliding reverses, stick begins and stick ends, and the state at the end."""

    reversed: tuple[mpf, ...]
    begun: tuple[mpf, ...]
    ended: tuple[mpf, ...]
    displacement: mpf
    velocity: mpf


def with_friction(
    oscillator: Oscillator, kinetic: float, static: float, start: tuple, end: mpf
) -> FrictionMotion:
    """Move an oscillator with dry friction against the ground; it begins in motion."""
    width = 2 * mp.pi / oscillator.omega / GRID
    time, x, sign = mpf(0), mpf(start[0]), 1 if start[1] > 0 else -1
    v = mpf(start[1])
    reversals, begun, ended = [], [], []

    def load(t):
        drive = oscillator.amplitude * mpmath.sin(oscillator.omega * t + oscillator.phase)
        return oscillator.constant + drive - oscillator.stiffness * x

    while True:
        slides = replace(oscillator, constant=mpf(oscillator.constant) - sign * mpf(kinetic)).free(time, x, v)
        time = first_negative(lambda t, slides=slides, sign=sign: sign * slides(t, 1), time, end, width)
        if time is None:
            return FrictionMotion(tuple(reversals), tuple(begun), tuple(ended), slides(end), slides(end, 1))
        x, v = slides(time), mpf(0)
        if abs(load(time)) > static:
            reversals.append(time)
            sign = -sign
            continue
        begun.append(time)
        time = first_negative(lambda t: static - abs(load(t)), time, end, width)
        if time is None:
            return FrictionMotion(tuple(reversals), tuple(begun), tuple(ended), x, mpf(0))
        ended.append(time)
        sign = 1 if load(time) > 0 else -1
