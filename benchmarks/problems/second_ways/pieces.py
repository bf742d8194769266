"""The second way of the machines: piece by piece with SciPy's DOP853, from the equations of the statement.

Nothing of the package is used. A piece ends where an event function passes zero; what each element does
from then on is written out below. The state is y = (q, q', z of the contacts, what a controller keeps).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from benchmarks.problems.second_ways.elements import Contact, Friction, Wall, nothing
from benchmarks.problems.second_ways.flight import Flight

METHOD, RTOL, ATOL = "DOP853", 1e-13, 1e-17
"""What solve_ivp is asked with; the peers ask with its defaults too."""


@dataclass(frozen=True, eq=False)
class Machine:
    """M q'' + C q' + K q = force(t) + what contacts, frictions, walls and a controller give.

    ``control(t, y)`` returns forces on q and the rates of the kept states; ``corners(t, y)`` is zero
    where such a law has a corner, ``breaks`` are times at which a force has one.
    """

    mass: np.ndarray
    damping: np.ndarray
    stiffness: np.ndarray
    force: Callable[[float], np.ndarray]
    contacts: tuple[Contact, ...] = ()
    frictions: tuple[Friction, ...] = ()
    walls: tuple[Wall, ...] = ()
    control: Callable[[float, np.ndarray], tuple[np.ndarray, np.ndarray]] | None = None
    corners: Sequence[Callable[[float, np.ndarray], float]] = ()
    breaks: Sequence[float] = ()
    kept: int = 0
    made: dict = field(default_factory=dict)

    @property
    def n(self) -> int:
        """Number of coordinates."""
        return len(self.mass)

    def split(self, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return q, q' and z."""
        return y[: self.n], y[self.n : 2 * self.n], y[2 * self.n : 2 * self.n + len(self.contacts)]

    def tension(self, t: float, y: np.ndarray, place: int, mode: int) -> float:
        """Return T of a contact in a mode."""
        if mode == 0:
            return 0.0
        each = self.contacts[place]
        q, v, _ = self.split(y)
        s, rate = each.s(t, q, v)
        return each.k * (s - (each.upper if mode > 0 else each.lower)) + each.c * rate

    def parts(self, modes: tuple[int, ...]) -> tuple:
        """Return what stays in a mode: matrices with closed contacts, their pins, and how stick holds."""
        if modes not in self.made:
            n, stiffness, damping = len(self.contacts), self.stiffness.copy(), self.damping.copy()
            constant, pins = np.zeros(self.n), []
            for each, mode in zip(self.contacts, modes, strict=False):
                if mode:
                    w = np.asarray(each.w)
                    stiffness, damping = (
                        stiffness + each.k * np.outer(w, w),
                        damping + each.c * np.outer(w, w),
                    )
                    constant = constant + w * each.k * (each.upper if mode > 0 else each.lower)
                    if each.pin is not nothing:
                        pins.append((w, each))
            inverse = np.linalg.inv(self.mass)
            stuck = [i for i in range(len(self.frictions)) if modes[n + i] == 0]
            sliding = [
                (i, np.asarray(self.frictions[i].w), modes[n + i])
                for i in range(len(self.frictions))
                if modes[n + i]
            ]
            w = np.array([self.frictions[i].w for i in stuck]).reshape(len(stuck), self.n)
            holds = np.linalg.inv(w @ inverse @ w.T)
            self.made[modes] = stiffness, damping, constant, pins, inverse, stuck, sliding, w, holds
        return self.made[modes]

    def acceleration(self, t: float, y: np.ndarray, modes: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
        """Return q'' and the forces of the frictions, along w."""
        stiffness, damping, constant, pins, inverse, stuck, sliding, w, holds = self.parts(modes)
        q, v = y[: self.n], y[self.n : 2 * self.n]
        total = self.force(t) + constant - damping @ v - stiffness @ q
        if self.control is not None:
            total = total + self.control(t, y)[0]
        for direction, each in pins:
            at, rate, _ = each.pin(t)
            total = total - direction * (each.k * at + each.c * rate)
        along = np.zeros(len(self.frictions))
        for place, direction, mode in sliding:
            each = self.frictions[place]
            u = direction @ v + each.pin(t)[1]
            along[place] = -mode * each.force(abs(u)) - each.d * u
            total = total + direction * along[place]
        free = inverse @ total
        if stuck:
            holding = holds @ ([-self.frictions[place].pin(t)[2] for place in stuck] - w @ free)
            along[stuck] = holding
            free = free + inverse @ (w.T @ holding)
        return free, along

    def rate(self, t: float, y: np.ndarray, modes: tuple[int, ...]) -> np.ndarray:
        """Return y' in a mode."""
        n, rate = self.n, np.zeros(len(y))
        rate[:n] = y[n : 2 * n]
        rate[n : 2 * n] = self.acceleration(t, y, modes)[0]
        for i, each in enumerate(self.contacts):
            if each.c and not modes[i]:
                rate[2 * n + i] = -each.k / each.c * y[2 * n + i]
        if self.control is not None:
            rate[2 * n + len(self.contacts) :] = self.control(t, y)[1]
        return rate

    def settled(self, t: float, y: np.ndarray, modes: tuple[int, ...]) -> tuple[int, ...]:
        """Return the modes once frictions that cannot hold have let go, the most loaded first."""
        first = len(self.contacts)
        for _ in self.frictions:
            along = self.acceleration(t, y, modes)[1]
            load = [
                abs(h) / each.static - 1.0 if modes[first + i] == 0 and each.static else -1.0
                for i, (h, each) in enumerate(zip(along, self.frictions, strict=True))
            ]
            worst = int(np.argmax(load)) if load else 0
            if not load or load[worst] <= 1e-9:
                break
            modes = _with(modes, first + worst, -int(np.sign(along[worst])))
        return modes

    def _events(self, modes: tuple[int, ...]) -> list[tuple[Callable, int, int, float]]:
        """Return functions that fall through zero (or pass it: 0), the element's place and its next mode."""
        found: list[tuple[Callable, int, int, float]] = []
        for i, each in enumerate(self.contacts):
            if modes[i]:
                found.append((lambda t, y, i=i: modes[i] * self.tension(t, y, i, modes[i]), i, 0, -1))
            for side, edge in ((1, each.upper), (-1, each.lower)):
                if not modes[i] and np.isfinite(edge):
                    found.append((partial(self._room, i, side, edge), i, side, -1))
        first = len(self.contacts)
        for i in range(len(self.frictions)):
            found += (
                self._ends_of_slip(first, i, modes)
                if modes[first + i]
                else self._ends_of_stick(first, i, modes)
            )
        first += len(self.frictions)
        for i, each in enumerate(self.walls):
            found.append(
                (lambda t, y, w=each: w.gap - np.dot(w.w, y[: self.n]) - w.pin(t)[0], first + i, 0, -1)
            )
        return found + [(corner, -1, 0, 0) for corner in self.corners]

    def _room(self, i: int, side: int, edge: float, t: float, y: np.ndarray) -> float:
        q, v, z = self.split(y)
        return side * (edge - (self.contacts[i].s(t, q, v)[0] - z[i]))

    def _ends_of_slip(self, first: int, i: int, modes: tuple[int, ...]) -> list[tuple]:
        each, mode, n = self.frictions[i], modes[first + i], self.n
        turns = (lambda t, y: mode * each.u(t, y[n : 2 * n]), first + i, 0, -1)
        return [
            turns,
            *((lambda t, y, k=k: abs(each.u(t, y[n : 2 * n])) - k, first + i, mode, 0) for k in each.knots),
        ]

    def _ends_of_stick(self, first: int, i: int, modes: tuple[int, ...]) -> list[tuple]:
        def left(sign: int, t: float, y: np.ndarray) -> float:
            return self.frictions[i].static - sign * self.acceleration(t, y, modes)[1][i]

        return [(partial(left, sign), first + i, -sign, -1) for sign in (1, -1)]

    def after(self, t: float, y: np.ndarray, modes: tuple[int, ...], place: int, mode: int):
        """Return state, modes and the rate before, behind an event of an element."""
        q, v, _ = self.split(y)
        y = y.copy()
        rate, first = 0.0, len(self.contacts) + len(self.frictions)
        if 0 <= place < len(self.contacts):
            each = self.contacts[place]
            rate = each.s(t, q, v)[1]
            edge = each.upper if (mode or modes[place]) > 0 else each.lower
            # In touch z follows s; the state keeps what it is once the contact lets go.
            y[2 * self.n + place] = each.s(t, q, v)[0] - edge if each.c else 0.0
        if place >= first:
            wall = self.walls[place - first]
            rate = float(np.dot(wall.w, v)) + wall.pin(t)[1]
            turned = np.linalg.solve(self.mass, np.asarray(wall.w))
            y[self.n : 2 * self.n] -= turned * (1.0 + wall.e) * rate / np.dot(wall.w, turned)
        elif place >= 0:
            modes = _with(modes, place, mode)
        return y, self.settled(t, y, modes), rate

    def begin(self, t: float, y: np.ndarray) -> tuple[int, ...]:
        """Return the modes of a state: contacts by s and T, frictions by u and by what holds."""
        q, v, z = self.split(y)
        modes = []
        for i, each in enumerate(self.contacts):
            s = each.s(t, q, v)[0]
            side = 1 if s - z[i] >= each.upper else -1 if s - z[i] <= each.lower else 0
            modes.append(side if side and side * self.tension(t, y, i, side) > 0 else 0)
        speeds = [each.u(t, v) for each in self.frictions]
        modes += [0 if abs(u) < 1e-14 else int(np.sign(u)) for u in speeds]
        return self.settled(t, y, tuple(modes))

    def fly(
        self, t: float, y: np.ndarray, until: float, modes: tuple[int, ...] | None = None, rtol: float = 0.0
    ) -> Flight:
        """Return the motion from a state to a time; ``rtol`` may be coarser than RTOL, not finer."""
        rtol = max(rtol, RTOL)
        y = np.array(y, dtype=float)
        modes = self.begin(t, y) if modes is None else modes
        flight = Flight()
        while t < until:
            stop = min([each for each in self.breaks if t < each < until], default=until)
            events, functions = self._events(modes), []
            beside = 1e-9 * (stop - t)
            for function, _, _, direction in events:
                # A corner is met from the side on which the motion is just behind the start of the piece.
                side = direction or -np.sign(function(t + beside, y + beside * self.rate(t, y, modes)))

                def ends(
                    t: float, y: np.ndarray, function: Callable = function, side: float = -side
                ) -> float:
                    return float(side * function(t, y))

                ends.terminal, ends.direction = True, -1
                functions.append(ends)
            ended = solve_ivp(
                lambda t, y, modes=modes: self.rate(t, y, modes),
                (t, stop),
                y,
                method=METHOD,
                rtol=rtol,
                atol=ATOL * (rtol / RTOL),
                events=functions,
                dense_output=True,
                max_step=(stop - t) / 8,
            )
            flight.pieces.append((ended.sol, t, float(ended.t[-1]), modes))
            t, y = float(ended.t[-1]), ended.y[:, -1]
            if ended.status == 1:
                number = next(i for i, times in enumerate(ended.t_events) if times.size)
                place, mode = events[number][1:3]
                y, modes, rate = self.after(t, y, modes, place, mode)
                if place >= 0 and events[number][3]:
                    flight.events.append((t, place, mode, rate))
        return replace(flight, time=t, state=y, modes=modes)

    def linear(self, modes: tuple[int, ...]) -> np.ndarray:
        """Return the matrix of (q, q') in modes of contacts alone."""
        stiffness, damping, _, _, inverse, *_ = self.parts(modes)
        unit = np.eye(self.n)
        return np.block([[0 * unit, unit], [-inverse @ stiffness, -inverse @ damping]])

    def monodromy(self, flight: Flight) -> np.ndarray:
        """Return d y_end / d y_begin where the right-hand side is continuous: contacts without damping."""
        total = np.eye(2 * self.n)
        for _, begin, end, modes in flight.pieces:
            total = expm(self.linear(modes) * (end - begin)) @ total
        return total


def _with(modes: tuple[int, ...], place: int, mode: int) -> tuple[int, ...]:
    return (*modes[:place], mode, *modes[place + 1 :])
