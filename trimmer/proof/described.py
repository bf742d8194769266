"""Describing functions in balls, from the closed forms alone.

An element is a sum of terms in parallel. What is linear in it goes to the plant. The rest is, with u = 1/A:
square waves, (4/pi) c u; corners, w f(x u) with f of a saturation of slope 1; relays with thresholds; plays.

Notation of plays: the load rests against the pin until the phase atan(1/gamma), gamma = omega M/D, and
flies freely for the angle t. With c = gamma/sqrt(1 + gamma^2), s = 1/sqrt(1 + gamma^2), E = exp(-t/gamma)
that takes

    gap u = c gamma (1 - E) - c sin t + s (1 - cos t),
    N = 1 - t/pi - w (1 - exp(-2jt))/(2j pi) - (2j/pi) k (1 - E exp(-jt)),

w = -(1 + j gamma)/(1 - j gamma), k = gamma^2/(1 + gamma^2); gamma = 0 is friction-controlled backlash. The
first integrates the velocity of the load relative to the pin, the second is 1 plus the integral of
(2/pi) exp(-j phase of impact) over gap u (Gelb and Vander Velde, 1968).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from flint import acb, arb, fmpq

from trimmer.proof.balls import PI, I, exact, hull
from trimmer.proof.statement import FROM_ZERO, NUMBERS, WITHOUT, Term


@dataclass
class Parts:
    """What an element is made of, all numbers exact."""

    gain: fmpq = field(default_factory=lambda: fmpq(0))  # Linear part of N
    damping: fmpq = field(default_factory=lambda: fmpq(0))  # N holds j omega times this
    # Real and imaginary part of c
    square: tuple[fmpq, fmpq] = field(default_factory=lambda: (fmpq(0), fmpq(0)))
    corners: list[tuple[fmpq, fmpq]] = field(default_factory=list)  # Weight w and threshold x of each
    # Level, inputs at which it switches on and off
    relays: list[tuple[fmpq, fmpq, fmpq]] = field(default_factory=list)
    # Weight, gap, time constant (None: infinite), and the frequency at which N is frozen, or None
    plays: list[tuple[fmpq, fmpq, fmpq | None, fmpq | None]] = field(default_factory=list)

    @classmethod
    def of(cls, terms: Iterable[Term]) -> Parts:
        """Add the terms of a file."""
        parts = cls()
        for term in terms:
            weight, numbers = _numbers(term)
            parts._add(str(term["kind"]), weight, numbers)
        return parts

    def _add(self, kind: str, weight: fmpq, numbers: dict[str, Any]) -> None:
        if kind == "backlash":
            self.plays.append((weight, numbers["gap"], numbers["time_constant"], numbers["frozen_omega"]))
        elif kind == "Coulomb friction":
            self.square = (self.square[0], self.square[1] + weight * numbers["force"])
        elif kind == "viscous friction":
            self.damping += weight * numbers["damping"]
        elif kind in ("relay", "preload"):
            level, zero = weight * numbers["level"], fmpq(0)
            self.gain += weight * numbers.get("slope", zero)
            middle, half = numbers.get("dead_zone", zero), numbers.get("hysteresis", zero)
            if middle + half == 0:
                self.square = (self.square[0] + level, self.square[1])
            else:
                self.relays.append((level, middle + half, middle - half))
        else:
            slope = weight * numbers["slope"]
            if kind == "dead zone":
                self.gain, slope = self.gain + slope, -slope
            self.corners.append((slope, numbers["threshold"]))


def _numbers(term: Term) -> tuple[fmpq, dict[str, Any]]:
    """Return the product of the factors of a term, and its numbers, each in its range."""
    kind, factors = term.get("kind"), term.get("factors")
    if kind not in NUMBERS:
        raise ValueError(f"the kind {kind!r} of an element is none that has a closed form here")
    if set(term) != {"kind", "factors", *NUMBERS[str(kind)]} or not isinstance(factors, tuple):
        raise ValueError(f"a {kind} has factors, {', '.join(NUMBERS[str(kind)])}, and nothing else")
    weight = fmpq(1)
    numbers: dict[str, Any] = {}
    for name in NUMBERS[str(kind)]:
        value = term[name]
        if value is None and name in WITHOUT:
            numbers[name] = None
        elif isinstance(value, float) and (value > 0 or (value == 0 and name in FROM_ZERO)):
            numbers[name] = exact(value)
        else:
            raise ValueError(f"{name} of a {kind} is {value!r}")
    if numbers.get("frozen_omega") is not None and not numbers["time_constant"]:
        raise ValueError("a backlash that is no matter of frequency is frozen at one")
    for factor in factors:
        weight *= exact(factor)
    if weight == 0:
        raise ValueError(f"a factor of a {kind} is 0")
    return weight, numbers


def corner(x: arb) -> tuple[arb, arb]:
    """Enclose f and its derivative, f = (2/pi)(asin x + x sqrt(1 - x^2)) up to x = 1 and 1 beyond."""
    ends = [_corner_at(each) for each in (x.lower(), x.upper())]
    slope = (4 / PI) * (1 - x * x).nonnegative_part().sqrt() if not x > 1 else arb(0)
    return ends[0].union(ends[1]), slope if x < 1 else slope.union(arb(0))


def _corner_at(x: arb) -> arb:
    if not x < 1:
        return arb(1)
    return (2 / PI) * (x.asin() + x * (1 - x * x).sqrt())


def ideal_play(flight: arb) -> tuple[acb, acb]:
    """Enclose N of friction-controlled backlash and its derivative by the flight."""
    sine, cosine = flight.sin_cos()
    gain = acb(1 - (flight - sine * cosine) / PI, -sine * sine / PI)
    return gain, acb(-2 * sine * sine / PI, -2 * sine * cosine / PI)


Play = tuple[arb, arb, arb, acb, acb, acb]
"""Gap u and its derivatives by flight and gamma; N and the same."""


def carried_play(t: arb, gamma: arb) -> Play:
    """Enclose a play whose load goes on by itself; gamma may reach down to 0."""
    sine, cosine = t.sin_cos()
    ends = gamma.lower().max(arb(0)), gamma.upper()
    square = (1 + ends[0] ** 2).union(1 + ends[1] ** 2)
    root = square.rsqrt()
    s, c = root, (ends[0] / (1 + ends[0] ** 2).sqrt()).union(ends[1] / (1 + ends[1] ** 2).sqrt())
    decay = _decay(t, gamma)
    turned = acb(cosine, -sine)
    w = -(acb(s, c) ** 2)
    k = c * c
    twice = (1 - turned * turned) / (2 * I)
    velocity = c * decay - c * cosine + s * sine
    by_gamma = root**3 * (gamma * (1 - decay) - sine - gamma * (1 - cosine)) + c * (1 - decay)
    by_gamma -= root * t * decay
    gain_by_gamma = (2 * I / PI) * (acb(s, c) * s) ** 2 * twice
    gain_by_gamma -= (2 * I / PI) * (2 * c * s**3 * (1 - decay * turned) - t * s * s * decay * turned)
    return (
        c * gamma * (1 - decay) - c * sine + s * (1 - cosine),
        velocity,
        by_gamma,
        1 - t / PI - w * twice / PI - (2 * I / PI) * k * (1 - decay * turned),
        (2 / PI) * acb(c, -s) * turned * velocity,
        gain_by_gamma,
    )


def _decay(t: arb, gamma: arb) -> arb:
    """Enclose exp(-t/gamma) by its values at the ends; towards gamma = 0 for t and gamma from 0 on."""
    first, last, least, largest = t.lower(), t.upper(), gamma.lower(), gamma.upper()
    if not least > 0:
        return hull(0, (-first.max(arb(0)) / largest).exp())
    ends = [(-each / divisor).exp() for each in (first, last) for divisor in (least, largest)]
    return ends[0].union(ends[1]).union(ends[2]).union(ends[3])


def thrown_play(t: arb) -> Play:
    """Enclose the same with an infinite time constant."""
    sine, cosine = t.sin_cos()
    turned = acb(cosine, -sine)
    gain = 1 - t / PI - (1 - turned * turned) / (2 * I * PI) - (2 * I / PI) * (1 - turned)
    velocity = 1 - cosine
    return t - sine, velocity, arb(0), gain, (2 / PI) * turned * velocity, acb(0)
