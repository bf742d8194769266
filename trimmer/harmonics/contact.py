"""Plays and stops in harmonic balance: when they are in contact, and the harmonics of their force."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trimmer.harmonics.crossings import crossings
from trimmer.harmonics.forces import Harmonics, Pieces, piecewise, with_moving_ends
from trimmer.harmonics.waveform import Decay, PeriodicWaveform
from trimmer.mechanism.parts import ContactLaw, Play, Stop

SKIPPED = 1e-5
"""Share of the period after a release in which the same side is not sought: the distance is a double zero."""
MOST_CONTACTS = 400


@dataclass(frozen=True, eq=False)
class HarmonicContact:
    """A play or stop, with its distance s between the ends, m."""

    part: Play | Stop
    distance: PeriodicWaveform

    @property
    def offsets(self) -> dict[int, float]:
        """Distance at which contact begins on either side, m, by the side."""
        half = 0.5 * self.part.gap
        return {1: half, -1: -half} if isinstance(self.part, Play) else {1: self.part.gap}

    @property
    def law(self) -> ContactLaw:
        """The law of contact; without damping all give the same force."""
        return self.part.law if self.part.damping > 0.0 else ContactLaw.PULLING

    def force(self, side: int) -> PeriodicWaveform:
        """Return the force in contact on a side, N; positive if it pulls the ends together."""
        factors = self.part.stiffness + self.part.damping * self.distance.turning
        unshifted = PeriodicWaveform(factors * self.distance.coefficients, self.distance.omega)
        return unshifted.shifted(-self.part.stiffness * self.offsets[side])

    def harmonics(self) -> Harmonics:
        """Return the harmonics of the force as functions of those of the distance."""
        relaxing = self.law is ContactLaw.RELAXING
        spans = list(self._relaxing() if relaxing else self._without_memory())
        count, part = len(self.distance.coefficients), self.part
        factors = part.stiffness + part.damping * self.distance.turning
        total = Harmonics(np.zeros(count, dtype=complex), *np.zeros((2, count, count), dtype=complex))
        for side, offset in self.offsets.items():
            of_side = [(begin, end) for begin, end, on in spans if on == side]
            if of_side:
                begin, end = np.array(of_side).T
                pieces = Pieces(begin, end, np.ones(len(begin)))
                fixed = piecewise(self.distance, factors, part.stiffness * offset, pieces)
                total = total + self._with_onsets(fixed, side, pieces)
        return total

    def _with_onsets(self, fixed: Harmonics, side: int, pieces: Pieces) -> Harmonics:
        """Add what changes because the ends of contact move, where the damper makes the force jump."""
        force, weights = self.force(side), np.ones(len(self.distance.coefficients), dtype=complex)
        moments = np.concatenate([pieces.begin, pieces.end])
        jumps = np.concatenate([force.at(pieces.begin), -force.at(pieces.end)])
        steepness = abs(self.distance.slope(moments))
        real = (abs(jumps) > 1e-9 * abs(force.coefficients).sum()) & (steepness > 0.0)
        amounts = jumps[real] / self.distance.slope(moments)[real]
        return with_moving_ends(fixed, self.distance, moments[real], amounts, weights)

    def _without_memory(self) -> Iterator[tuple[float, float, int]]:
        """Yield begin, end and side of contact over a period with the truncated or pulling law."""
        period = self.distance.period
        for side, offset in self.offsets.items():
            beyond, force = self.distance.shifted(-offset), self.force(side)
            edges = [np.array([0.0, period]), crossings(beyond, 0.0, period)]
            truncated = self.law is ContactLaw.TRUNCATED
            if truncated:
                edges.append(crossings(force, 0.0, period))
            times = np.sort(np.concatenate(edges))
            middle = 0.5 * (times[1:] + times[:-1])
            acts = np.sign(beyond.at(middle)) == side
            if truncated:
                acts &= np.sign(force.at(middle)) == side
            for begin, end in zip(times[:-1][acts].tolist(), times[1:][acts].tolist(), strict=True):
                yield begin, end, side

    def _relaxing(self) -> Iterator[tuple[float, float, int]]:
        """Yield begin, end and side of contact over the second period from rest of the spring."""
        period, rate = self.distance.period, self.part.stiffness / self.part.damping
        time, z = 0.0, self._stretch_at(0.0)
        side = int(np.sign(z))
        if side and np.sign(self.force(side).at(np.array(0.0))) != side:
            side = 0
        released = 0
        for _ in range(MOST_CONTACTS):
            if not side:
                time, side = self._made(time, Decay(z, rate, time), released)
                if not side or time >= 2.0 * period:
                    return
            end = self._released(time, side)
            if end is None:
                yield period, 2.0 * period, side
                return
            if time >= period:
                yield time, end, side
            time, released = end, side
            z = float(self.distance.at(np.array(end))) - self.offsets[side]
            side = 0

    def _stretch_at(self, time: float) -> float:
        distance = float(self.distance.at(np.array(time)))
        return distance - min(max(distance, self.offsets.get(-1, -math.inf)), self.offsets[1])

    def _made(self, time: float, decay: Decay, released: int) -> tuple[float, int]:
        """Return when and on which side contact is made next; side 0 if not within two periods."""
        period = self.distance.period
        found = []
        for side, offset in self.offsets.items():
            gap = PeriodicWaveform(self.distance.coefficients, self.distance.omega, decay).shifted(-offset)
            skipped = SKIPPED * period if side == released else 0.0
            for begin, end in ((time + skipped, time + period), (time + period, time + 2.0 * period)):
                moments = crossings(gap, begin, end)
                entered = moments[np.sign(gap.slope(moments)) == side]
                if len(entered):
                    found.append((float(entered[0]), side))
                    break
        return min(found, default=(time, 0))

    def _released(self, time: float, side: int) -> float | None:
        """Return when the force on a side vanishes next, None if it never does."""
        force, period = self.force(side), self.distance.period
        moments = crossings(force, time, time + period)
        falling = moments[np.sign(force.slope(moments)) == -side]
        return float(falling[0]) if len(falling) else None
