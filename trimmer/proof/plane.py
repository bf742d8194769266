"""1 + N G = 0 in the plane of flight and omega: boxes without a solution, and boxes with exactly one.

In place of the amplitude stands the flight t of the element that needs the largest amplitude, from 0 (an
infinite one) to pi (the smallest): of a play, the angle in which its load flies; a relay that switches on at
x is taken as a play of 2x, 1/A = (1 - cos t)/(2x). N is then analytic, with finite slopes, over the closed
range. With F = den + N num: a box is without a solution if F in its middle is larger than its slopes allow
it to change; it has exactly one if Krawczyk's operator maps it into itself (R. Krawczyk, Computing 4, 1969).
Frequencies from 0 on and up to infinity are boxes too, in omega and in 1/omega. Where F vanishes in a corner,
as behind an integrator, the curves of N and -1/G are of different orders there (``is_parted_from``).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from flint import acb, acb_poly, arb, arb_mat, fmpq, fmpq_poly

from trimmer.proof.balls import PI, about, along_axis, hull, in_balls, krawczyk
from trimmer.proof.described import Parts, carried_play, corner, ideal_play, thrown_play
from trimmer.proof.outcome import UndecidedError, require_time

LAST = math.nextafter(math.pi, 4.0)  # The end of the flights, rounded up
MOST_BOXES = 60000
SMALLEST = 1e-9  # Width of a box, relative, below which it is left undecided
CORNER = 0.05


@dataclass(frozen=True)
class Gain:
    """N and u = 1/A with their derivatives by flight and omega."""

    value: acb
    by_flight: acb
    by_omega: acb
    inverse: arb


class ElementGain:
    """N over flight and omega."""

    def __init__(self, parts: Parts) -> None:
        """Choose what the flight is of."""
        self.parts = parts
        limits = [(gap / 2, place) for place, (_, gap, _, _) in enumerate(parts.plays)]
        limits += [(on, -1 - place) for place, (_, on, _) in enumerate(parts.relays)]
        if not limits:
            raise UndecidedError("N turns with the amplitude down to amplitude 0, which is not covered")
        self.limit, place = max(limits)
        self.moving = [each for each in parts.plays if each[2] != 0]
        self.still = [each for each in parts.plays if each[2] == 0]
        alone = len(parts.plays) + len(parts.relays) == 1
        has_square = bool(parts.square[0] or parts.square[1])
        if self.moving and not alone:
            raise UndecidedError("a play with a time constant beside plays or relays is not covered")
        if place < 0:
            off = parts.relays[-1 - place][2]
            others = has_square or parts.corners or not alone
            if off >= 0 and others:
                raise UndecidedError("a relay that rests beside others is not covered below its threshold")
        self.turns_with_omega = any(lag is not None and frozen is None for _, _, lag, frozen in self.moving)
        self.vanishes = not (has_square or parts.corners or self.moving) and alone

    def at(self, t: arb, omega: arb) -> Gain:
        """Enclose N and u over flights and omega."""
        zero = acb(0)
        if self.moving:
            weight, gap, lag, frozen = self.moving[0]
            rate = arb(0) if lag is None or frozen is not None else arb(lag)
            gamma = rate * omega if lag is None or frozen is None else arb(lag * frozen)
            play = thrown_play(t) if lag is None else carried_play(t, gamma)
            u, by_t, by_omega = (each / arb(gap) for each in play[:3])
            value, slope, other = (each * arb(weight) for each in play[3:])
            by_omega, other = by_omega * rate, other * rate
        else:
            scale = 1 / (2 * arb(self.limit))
            u, by_t, by_omega = (1 - t.cos()) * scale, t.sin() * scale, arb(0)
            value = slope = other = zero
        by_u = zero
        square = acb(arb(self.parts.square[0]), arb(self.parts.square[1])) * 4 / PI
        value, by_u = value + square * u, by_u + square
        for size, threshold in self.parts.corners:
            share, steep = corner(u * arb(threshold))
            value, by_u = value + arb(size) * share, by_u + arb(size * threshold) * steep
        for level, on, off in self.parts.relays:
            turned, by_t_of = self._relay(t, u, by_t, on, off)
            value, slope = value + arb(level) * turned, slope + arb(level) * by_t_of
        for size, gap, _, _ in self.still:
            flight, stretch = self._flight(t, gap)
            gain, by_flight = ideal_play(flight)
            value, slope = value + arb(size) * gain, slope + arb(size) * by_flight * stretch
        return Gain(value, slope + by_u * by_t, other + by_u * by_omega, u)

    def is_parted_from(self, num: fmpq_poly, den: fmpq_poly, omega: float) -> bool:
        """Return whether -1/G and N are apart up to omega, within ``CORNER`` of the flight where N vanishes.

        A play has N = l^2 (a l - j b)/pi there, with l = pi - t, a within 1e-3 of 2/3 and b of 1; a relay
        (2/pi)(r u - j w u^2), w its on less its off, r within 1e-5 of 2. So Re(N)^2/|Im N|^3 is within 1 and
        2, or |Im N|/Re(N)^2 within w/3 and w/2. The same of -1/G must be outside: it is a power of omega, an
        odd one as Re is even and Im is odd, times a bounded function.
        """
        weight = self.parts.relays[0][0] if self.parts.relays else self.parts.plays[0][0]
        (a, b), (p, q) = along_axis(num), along_axis(den)
        parts = [(a * p + b * q) * -weight, (a * q - b * p) * -weight, (a * a + b * b) * weight * weight]
        if parts[0].is_zero() or parts[1].is_zero():
            return True
        powers = [next(place for place, each in enumerate(part.coeffs()) if each) for part in parts]
        reach = hull(0, omega)
        along, beside, size = (
            in_balls((part.right_shift(power) if power else part, fmpq_poly([0])))(acb(reach)).real
            for part, power in zip(parts, powers, strict=True)
        )
        if self.still:
            ratio, power = along**2 * size / abs(beside) ** 3, 2 * powers[0] + powers[2] - 3 * powers[1]
            least, largest = arb(1), arb(2)
        else:
            _, on, off = self.parts.relays[0]
            ratio, power = abs(beside) * size / along**2, powers[1] + powers[2] - 2 * powers[0]
            least, largest = arb(on - off) / 3, arb(on - off) / 2
        ratio *= arb(omega) ** power
        return bool(ratio < least if power > 0 else ratio > largest)

    def _flight(self, t: arb, gap: fmpq) -> tuple[arb, arb]:
        """Enclose the flight behind a play of a smaller gap: sin(m/2) = sqrt(q) sin(t/2)."""
        share = gap / (2 * self.limit)
        if share == 1:
            return t, arb(1)
        root, (sine, cosine) = arb(share).sqrt(), (t / 2).sin_cos()
        return 2 * (root * sine).asin(), root * cosine / (1 - arb(share) * sine * sine).sqrt()

    def _relay(self, t: arb, u: arb, by_t: arb, on: fmpq, off: fmpq) -> tuple[acb, acb]:
        """Enclose (2/pi) u (exp(-j asin(on u)) + exp(j asin(off u))) and its derivative by t."""
        roots = [self._root(t, u, by_t, each) for each in (on, off)]
        both, slopes = roots[0][0] + roots[1][0], roots[0][1] + roots[1][1]
        width = arb(on - off)
        value = acb(u * both, -width * u * u) * 2 / PI
        return value, acb(by_t * both + u * slopes, -2 * width * u * by_t) * 2 / PI

    def _root(self, t: arb, u: arb, by_t: arb, x: fmpq) -> tuple[arb, arb]:
        """Enclose sqrt(1 - (x u)^2), which is cos(t/2) sqrt(1 + sin(t/2)^2) where t belongs to x."""
        if abs(x) == self.limit and not self.moving:
            sine, cosine = (t / 2).sin_cos()
            root = (1 + sine * sine).sqrt()
            return cosine * root, -sine * root / 2 + cosine * sine * cosine / (2 * root)
        root = (1 - (arb(x) * u) ** 2).sqrt()
        return root, -arb(x * x) * u * by_t / root


@dataclass(frozen=True)
class Box:
    """Flights and omegas between ends that are doubles."""

    t: tuple[float, float]
    omega: tuple[float, float]

    @property
    def balls(self) -> tuple[arb, arb]:
        """Both as balls."""
        return hull(*self.t), hull(*self.omega)

    def halves(self, along_t: bool) -> tuple[Box, Box]:
        """Divide it, the omegas in their geometric middle."""
        if along_t:
            middle = self.t[0] + 0.4871 * (self.t[1] - self.t[0])
            return Box((self.t[0], middle), self.omega), Box((middle, self.t[1]), self.omega)
        lower, upper = self.omega
        middle = lower * (upper / lower) ** 0.4871 if lower > 0 else 0.4871 * upper
        return Box(self.t, (lower, middle)), Box(self.t, (middle, upper))


Solved = tuple[arb, arb]


class Plane:
    """F over the plane, and what was found in it."""

    def __init__(self, num: fmpq_poly, den: fmpq_poly, parts: Parts) -> None:
        """Take den + N num, the linear part of the element already in den."""
        self.num, self.den, self.element = num, den, ElementGain(parts)
        self.sides = in_balls(along_axis(num)), in_balls(along_axis(den))
        self.order = max(den.degree(), num.degree())
        self.found: list[tuple[Solved, Solved]] = []  # Balls of exactly one solution each, and it
        self.examined = 0

    def solutions(self, omegas: tuple[float, float] | None) -> Iterator[tuple[arb, arb]]:
        """Enclose amplitude and omega of all solutions, at all frequencies or in a range."""
        left = self._search(Box((0.0, LAST), omegas or self._all_omegas()), self._solve, SMALLEST)
        if left is not None:
            u = float(self.element.at(*left.balls).inverse.mid())
            raise UndecidedError(
                f"the curves of N and -1/G touch, coincide or end near {left.omega[1]:.9g} rad/s and "
                f"amplitude {1 / u if u else math.inf:.6g}, as near as balls tell"
            )
        for _, (t, omega) in self.found:
            if t < 0 or t > PI:
                continue
            if not (t > 0 and t < PI):
                raise UndecidedError("a solution stands at the smallest or an infinite amplitude")
            yield 1 / self.element.at(t, omega).inverse, omega

    def _search(self, start: Box, settled: Callable[[Box], bool | None], smallest: float) -> Box | None:
        """Divide a box until all its parts are settled; return one that is too small for that."""
        waiting = [start]
        while waiting:
            require_time()
            self.examined += 1
            box = waiting.pop()
            answer = settled(box)
            if answer is None:
                continue
            if box.t[1] - box.t[0] < smallest or self.examined > MOST_BOXES:
                return box
            waiting += box.halves(answer)
        return None

    def _slopes(self, t: arb, omega: arb) -> tuple[acb, acb, acb, arb, arb]:
        """Enclose F in the middle of a box, its derivatives over it, and the box about its middle."""
        middles = arb(t.mid()), arb(omega.mid())
        reach = t - middles[0], omega - middles[1]
        num, den = (each(acb_poly([acb(middles[1]), 1])) for each in self.sides)
        here, around = self.element.at(*middles), self.element.at(t, omega)
        step = acb(reach[1])
        over = num(step)
        by_omega = den.derivative()(step) + around.value * num.derivative()(step) + around.by_omega * over
        middle = den(acb(0)) + here.value * num(acb(0))
        return middle, around.by_flight * over, by_omega, *reach

    def _solve(self, box: Box) -> bool | None:
        """Settle a box (None), or say whether to divide its flights."""
        t, omega = box.balls
        slopes = self._slopes(t, omega)
        if _is_apart(*slopes):
            return None
        lower = (omega.lower() - omega.rad()).max(omega.lower() / 2)
        larger = t + about(t.rad()), hull(lower, omega.upper() + omega.rad())
        enclosed = self._krawczyk(larger)
        if enclosed is not None:
            if not any(_holds(other, enclosed) for other, _ in self.found):
                self.found.append((larger, enclosed))
            return None
        if box.omega[1] > 4.0 * box.omega[0]:
            return False
        by_t, by_omega = (
            float(abs(slope).upper() * each.rad())
            for slope, each in zip(slopes[1:3], (t, omega), strict=True)
        )
        return not by_t < by_omega

    def _krawczyk(self, around: Solved) -> Solved | None:
        """Enclose the solution in a box if it has exactly one."""
        image = self._image(around)
        if image is None or not _holds(around, image):
            return None
        for _ in range(6):
            following = self._image(image)
            if following is None:
                break
            image = image[0].intersection(following[0]), image[1].intersection(following[1])
        return image

    def _image(self, around: Solved) -> Solved | None:
        middle, by_t, by_omega, *_ = self._slopes(*around)
        derivative = arb_mat([[by_t.real, by_omega.real], [by_t.imag, by_omega.imag]])
        try:
            t, omega = krawczyk(around, [-middle.real, -middle.imag], derivative)
        except ZeroDivisionError:
            return None
        return t, omega

    def _all_omegas(self) -> tuple[float, float]:
        """Return an omega below and one above which there is no solution."""
        lowest = 0.25 * _root_bound([self.num, self.den])
        highest = 4.0 / _root_bound([_backwards(self.num), _backwards(self.den)])
        return self._edge(lowest, 1 / 16, self._is_quiet_below, "frequency 0"), self._edge(
            highest, 16.0, self._is_quiet_above, "infinite frequency"
        )

    def _edge(self, omega: float, factor: float, is_quiet: Callable[[float], bool], where: str) -> float:
        for _ in range(12):
            if is_quiet(omega):
                return omega
            omega *= factor
        raise UndecidedError(f"nothing excludes solutions towards {where}")

    def _is_quiet_below(self, omega: float) -> bool:
        in_corner = self.den[0] == 0 and self.element.vanishes
        first = CORNER if in_corner and self.element.parts.relays else 0.0
        last = LAST - CORNER if in_corner and self.element.still else LAST
        parted = not in_corner or self.element.is_parted_from(self.num, self.den, omega)
        return parted and self._search(Box((first, last), (0.0, omega)), self._low_strip, 1e-3) is None

    def _is_quiet_above(self, omega: float) -> bool:
        return self._search(Box((0.0, LAST), (0.0, 1.0 / omega)), self._high_strip, 1e-3) is None

    def _low_strip(self, box: Box) -> bool | None:
        return None if _is_apart(*self._slopes(*box.balls)) else True

    def _high_strip(self, box: Box) -> bool | None:
        """Take omega**-n F as a function of 1/omega."""
        t, inverse = box.balls
        num, den = (in_balls(along_axis(each), self.order)(acb(inverse)) for each in (self.num, self.den))
        if self.element.turns_with_omega:
            # |N| < 1 + 1/pi + 4/pi by its closed form, at any gamma.
            value = arb(self.element.moving[0][0]) * acb(about(3), about(3))
            value += self._rest_of_moving(t)
        else:
            middle = 0.5 * (box.t[0] + box.t[1])
            here, around = self.element.at(arb(middle), arb(1)), self.element.at(t, arb(1))
            value = here.value + around.by_flight * (t - arb(middle))
        return None if not (den + value * num).contains(0) else True

    def _rest_of_moving(self, t: arb) -> acb:
        """Enclose what is beside a play with a time constant: gap u lies between 0 and pi."""
        u = hull(0, PI) / arb(self.element.moving[0][1])
        square = acb(arb(self.element.parts.square[0]), arb(self.element.parts.square[1])) * 4 / PI * u
        corners = [arb(weight) * hull(0, 1) for weight, _ in self.element.parts.corners]
        return square + sum(corners, arb(0))


def _is_apart(middle: acb, by_t: acb, by_omega: acb, t: arb, omega: arb) -> bool:
    """Return whether F vanishes nowhere in a box: its part along F in the middle stays positive."""
    along = acb(middle.mid()).conjugate()
    return bool((along * middle).real + (along * by_t).real * t + (along * by_omega).real * omega > 0)


def _holds(around: Solved, enclosed: Solved) -> bool:
    return all(ball.contains_interior(each) for ball, each in zip(around, enclosed, strict=True))


def _backwards(polynomial: fmpq_poly) -> fmpq_poly:
    return fmpq_poly(polynomial.coeffs()[::-1])


def _root_bound(polynomials: list[fmpq_poly]) -> float:
    """Return about the size of the smallest roots that are not 0; it only says where to begin."""
    smallest = math.inf
    for each in polynomials:
        sizes = [(power, _log(value)) for power, value in enumerate(each.coeffs()) if value]
        first, size = sizes[0]
        for power, other in sizes[1:]:
            smallest = min(smallest, math.exp((size - other) / (power - first)))
    return smallest if math.isfinite(smallest) else 1.0


def _log(value: fmpq) -> float:
    return float(abs(arb(value)).log().mid())
