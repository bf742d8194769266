"""What moves over a number: assembled anew for a value, or where all is affine in it, a sum of two.

What is no sum may still have equations that are polynomials, whose derivatives are known.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np

from trimmer.branches.period_maps.curved import Curved
from trimmer.branches.period_maps.value_flow import Slopes, changing
from trimmer.errors import TrimmerError
from trimmer.hybrid.affine_modes import AffineModes
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import System
from trimmer.motion.flow import Flow
from trimmer.motion.subject import Subject
from trimmer.response.flows import flow_of, known_flow_of

KEPT = 4  # Values whose flows are kept
WORTH = 2  # Values beyond all that are known from which on it is asked whether the equations are affine
TRIES = 2  # How often they may turn out not to be
WIDTH = 2.0  # Factor between a value and the ends of the interval in which they are then known


@dataclass(eq=False)
class _Family:
    """Flows over an interval of a number in which their equations are affine, with those at its ends."""

    first: float
    last: float
    flows: tuple[Flow, Flow, Flow]
    modes: AffineModes[Any]
    system: Callable[[Callable[[], Subject], float], System]
    _slopes: tuple[tuple[int, int], Slopes] | None = None

    def share(self, value: float) -> float | None:
        """Return how far a value is on the way; None outside."""
        share = (value - self.first) / (self.last - self.first)
        return share if 0.0 <= share <= 1.0 else None

    @property
    def slopes(self) -> Slopes:
        """Derivatives of the equations of the modes that are known so far."""
        modes, by = self.modes, self.last - self.first
        count = len(modes.first.statuses), len(modes.first.tables.resets)
        if self._slopes is None or self._slopes[0] != count:
            flow = modes.change("flow") / by
            found = Slopes(
                flow,
                np.array(list(map(changing, modes.first.tables.flow, flow)), dtype=np.int64),
                modes.change("hold") / by,
                np.ascontiguousarray(modes.change("taylor")[..., 0]) / by,
                modes.change("decayed") / by,
                modes.change("resets") / by,
            )
            self._slopes = count, found
        return self._slopes[1]

    @classmethod
    def of(cls, *flows: Flow, ends: tuple[float, float]) -> _Family | None:
        """Return the family of flows at both ends and midway; None if they are not affine."""
        first, middle, last = flows
        if first.modes.tables.rows is not None or not all(map(first.is_alike, flows)):
            return None
        system = first.between(middle, last)
        modes = AffineModes(*(each.modes for each in flows))
        return None if system is None else cls(*ends, (first, middle, last), modes, system)


class Flows:
    """The flows of a subject over one of its numbers.

    ``near`` is where the last orbit would go on, for each kind of passage.

    Args:
        subject: What moves.
        place: Dotted place of the number.
    """

    def __init__(self, subject: Subject, place: str) -> None:
        self.subject, self.place = subject, place
        self._own, self._known = subject.value(place), dict[float, Flow]()
        self._beyond, self._tries = 0, TRIES
        self._family: _Family | None = None
        self._curved: Curved | None = None
        self.near: dict[object, Instant] = {}

    def at(self, value: float) -> Flow:
        """Return the motion with a value of the number.

        Raises:
            MechanismError, LoopError: if the number cannot have that value.
        """
        if value not in self._known:
            flow = self._made(value)
            if len(self._known) >= KEPT:
                self._known.pop(next(iter(self._known)))
            self._known[value] = flow
        return self._known[value]

    def _made(self, value: float) -> Flow:
        if value == self._own:
            return known_flow_of(self.subject)
        # Between two values that a number can have it can have all, so that nothing is made to ask for it.
        subject = cache(partial(self.subject.with_value, self.place, value))
        share = None if self._family is None else self._family.share(value)
        if share is None and not (self._curved is not None and self._curved.holds(value)):
            self._beyond += 1
            if self._tries and self._beyond % WORTH == 0:
                self._family, self._curved = self._around(value)
                self._tries -= self._family is None and self._curved is None
                share = None if self._family is None else self._family.share(value)
        family = self._family
        # A flow that was made and not followed, as with a period below 0, has met no modes.
        latest = next((each for each in reversed(self._known.values()) if each.modes.statuses), None)
        if family is None or share is None or latest is None:
            return flow_of(subject())
        if not family.flows[0].is_alike(latest):  # A friction without a force is no part.
            return flow_of(subject())
        if not family.modes.learn(latest.modes):
            flow, self._family = flow_of(subject()), None
            values = family.first, (family.first + family.last) / 2, family.last, value
            self._curved = Curved.of(np.array(values), (*family.flows, flow))
            self._tries -= self._curved is None
            return flow
        return family.flows[0].with_modes(subject, family.modes.at(share, family.system(subject, share)))

    def _around(self, value: float) -> tuple[_Family | None, Curved | None]:
        """Return what is known around a value, if equations are affine there, or polynomials."""
        if not value:
            return None, None
        first, last = value / WIDTH, value * WIDTH
        values = np.array([first, (first + last) / 2, last, value])
        try:
            flows = (*(flow_of(self.subject.with_value(self.place, each)) for each in values.tolist()),)
        except TrimmerError:
            return None, None
        family = _Family.of(*flows[:3], ends=(first, last))
        return family, Curved.of(values, flows) if family is None else None

    def slopes(self, value: float, flow: Flow) -> tuple[System, float, Slopes, float] | None:
        """Return how equations change at a value: another system so far from it, and their derivatives.

        Last comes that of the logarithm of the drive's period. None where they are no polynomials of first or
        second degree, or number their modes otherwise than those of the flow at the value.
        """
        family = self._family
        if self._curved is not None and self._curved.holds(value) and self._curved.flows[0].is_alike(flow):
            found = self._curved.slopes(value, flow.modes)
            return None if found is None else (flow.modes.system, 1.0, found, self._curved.pace(value))
        if family is None or family.share(value) is None or not family.flows[0].is_alike(flow):
            return None
        if not family.modes.learn(flow.modes) or not family.modes.numbers_alike(flow.modes):
            return None
        far = family.last if abs(family.last - value) > abs(family.first - value) else family.first
        system = family.flows[2 if far == family.last else 0].modes.system
        return system, far - value, family.slopes, 0.0
