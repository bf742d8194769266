"""What is wrong with a record as far as its samples show: clipping, dropouts, few steps, a large offset."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Flags, Places, Reals
from trimmer.signals.fault import Clipping, Dropout, Fault, FaultCertainty, FewSteps, Offset
from trimmer.signals.signal import Signal

_SHORTEST_RUN = 3
_CREST = 12.0
"""How many steps of the converter a rounded crest falls beside a run of at least 3 samples, at most.

A parabola that stays within one step for r samples has a curvature of at most 8/r^2 steps per sample squared,
so the next sample is at most 4 (1 + 2/r)^2 steps below: 11.1 for r = 3.
"""
_SAME_LEVEL = 0.02
_MOST = 0.6
_ROUGH = 0.3
"""Share of sign changes of the curvature that shows noise from sample to sample; noise alone has 2/3."""
_STEEP = 2.0
_CLIPPED_SHARE = 0.005
_CLIPPED_EXCESS = 3.0
_LONG_RUN = 16
_LONGER = 8.0
_FEW_VALUES = 256
_OFTEN = 20
_LARGE_OFFSET = 3.0


def faults(signal: Signal) -> tuple[Fault, ...]:
    """Look for what is wrong with a record.

    Args:
        signal: The record, as it was measured: filters and resampling hide what is looked for.

    Raises:
        WrongTypeError: if it is no signal.
    """
    require_instance("signal", signal, Signal, "a trimmer.Signal")
    if np.all(signal.values == signal.values[0]):
        return ()
    runs = _Runs.of(signal.values)
    return tuple(_found(signal, runs))


def _found(signal: Signal, runs: _Runs) -> Iterator[Fault]:
    found = (look(signal, runs) for look in (_clipping, _dropout, _few_steps))
    yield from (fault for fault in found if fault is not None)
    mean, rms = float(signal.values.mean()), signal.rms
    if abs(mean) > _LARGE_OFFSET * rms:
        yield Offset(mean, abs(mean) / rms, signal.unit)


@dataclass(frozen=True, eq=False)
class _Runs:
    """Runs of equal samples, and the step of the converter."""

    values: Reals  # Samples, shape (n,)
    begins: Places  # Place of the first sample of each run, shape (m,)
    lengths: Places  # Number of samples of each, shape (m,)
    levels: Reals  # Different values, rising, shape (k,)
    step: float  # Smallest difference of two of them

    @classmethod
    def of(cls, values: Reals) -> _Runs:
        begins = np.concatenate([[0], np.flatnonzero(np.diff(values)) + 1])
        levels = np.unique(values)
        apart = np.diff(levels)
        return cls(values, begins, np.diff(begins, append=values.size), levels, float(apart.min()))

    @cached_property
    def _jumps(self) -> tuple[Reals, Reals]:
        """By how much the signal jumps before and after each run, 0 at the ends of the record."""
        steps = np.abs(np.diff(self.values[self.begins]))
        return np.append(0.0, steps), np.append(steps, 0.0)

    @property
    def abrupt(self) -> Flags:
        """Whether the signal enters or leaves each run faster than a rounded crest, shape (m,)."""
        return np.asarray(np.maximum(*self._jumps) > _CREST * self.step)

    def cut(self, which: Flags) -> bool:
        """Return whether most of some runs (m,) are cut off, rather than stand still.

        A smooth motion comes to stand still with a last step that the change of its steps can take away; one
        that is cut off comes with more. Noise would not stand still at all.
        """
        inside = np.repeat(which, self.lengths)
        near = inside.copy()
        near[1:] |= inside[:-1]
        near[:-1] |= inside[1:]
        curvature = np.diff(self.values, 2)[~near[1:-1]]
        if curvature.size < _SHORTEST_RUN:
            return False
        if np.mean(curvature[1:] * curvature[:-1] < 0) > _ROUGH:
            return True
        begins, ends = self.begins[which], self.begins[which] + self.lengths[which]
        inner = (begins >= _SHORTEST_RUN) & (ends + _SHORTEST_RUN <= self.values.size)
        arriving = [self.values[begins[inner] - back] for back in (1, 2, 3)]
        leaving = [self.values[ends[inner] + on] for on in (0, 1, 2)]
        fast = _is_fast(*arriving) & _is_fast(*leaving)
        return bool(np.count_nonzero(fast) >= max(_MOST * fast.size, 1))

    def at(self, value: float) -> Flags:
        """Which runs have a value, shape (m,)."""
        return np.asarray(self.values[self.begins] == value)


def _is_fast(first: Reals, second: Reals, third: Reals) -> Flags:
    """Return whether a step beside a run is larger than the change of steps there can take away."""
    step = np.abs(first - second)
    return np.asarray(step > _STEEP * np.abs(first - 2.0 * second + third))


def _clipping(signal: Signal, runs: _Runs) -> Clipping | None:
    ends = (float(runs.levels[-1]), float(runs.levels[0]))
    clipped = [_clipped_runs(signal, runs, value) for value in ends]
    if runs.levels.size < 3 or not any(found.any() for found in clipped):
        return None
    both = clipped[0] | clipped[1]
    largest, smallest = (
        int(runs.lengths[runs.at(value)].sum()) if found.any() else 0
        for value, found in zip(ends, clipped, strict=True)
    )
    level = max(abs(value) for value, found in zip(ends, clipped, strict=True) if found.any())
    opposite = abs(ends[0] + ends[1]) <= _SAME_LEVEL * (ends[0] - ends[1])
    symmetric = opposite and all(found.any() for found in clipped)
    several = symmetric or int(both.sum()) >= _SHORTEST_RUN
    if level >= 0.999 * signal.full_scale:
        certainty = FaultCertainty.CERTAIN
    else:
        certainty = FaultCertainty.LIKELY if several and runs.cut(both) else FaultCertainty.POSSIBLE
    first = float(signal.times[runs.begins[both][0]])
    return Clipping(certainty, largest, smallest, int(both.sum()), signal.values.size, first, level)


def _clipped_runs(signal: Signal, runs: _Runs, extreme: float) -> Flags:
    """Find the runs of an extreme value that look clipped, shape (m,).

    A run counts if it is more abrupt than a rounded crest. Where the converter's steps are too coarse to
    tell, runs count if the extreme value is much more frequent than the next one.
    """
    at = runs.at(extreme)
    shortest = 2 if abs(extreme) >= 0.999 * signal.full_scale else _SHORTEST_RUN
    long = at & (runs.lengths >= shortest) & (runs.lengths < _share(runs.values.size))
    abrupt = long & runs.abrupt
    if abrupt.any():
        return np.asarray(abrupt)
    rest = runs.levels[1] if extreme == runs.levels[0] else runs.levels[-2]
    count, others = int(runs.lengths[at].sum()), int(runs.lengths[runs.at(float(rest))].sum())
    many = count >= _CLIPPED_SHARE * runs.values.size and count > _CLIPPED_EXCESS * others
    return np.asarray(at & (runs.lengths >= 2) & many)


def _share(samples: int) -> float:
    """Longest run that may be a crest: longer ones are dropouts, or no vibration."""
    return max(8.0, 0.25 * samples)


def _dropout(signal: Signal, runs: _Runs) -> Dropout | None:
    """Find abrupt runs that are no crest, and far longer than others."""
    near = _SAME_LEVEL * float(runs.levels[-1] - runs.levels[0])
    held = runs.values[runs.begins]
    extreme = (held <= runs.levels[0] + near) | (held >= runs.levels[-1] - near)
    zero = runs.at(0.0)
    others = runs.lengths[~extreme & ~zero]
    enough = max(_LONG_RUN, _LONGER * float(np.median(others))) if others.size else _LONG_RUN
    long = (runs.lengths >= enough) & (~extreme | zero) & runs.abrupt
    if not long.any() or runs.levels.size < _SHORTEST_RUN:
        return None
    longest = int(np.argmax(runs.lengths * long))
    begin, length = int(runs.begins[longest]), int(runs.lengths[longest])
    start, rate = signal.start, signal.sample_rate
    value = float(runs.values[begin])
    return Dropout(
        start + begin / rate, start + (begin + length - 1) / rate, value, length, int(long.sum()) - 1
    )


def _few_steps(signal: Signal, runs: _Runs) -> FewSteps | None:
    count = runs.levels.size
    if count < 3 or count > _FEW_VALUES or signal.values.size < _OFTEN * count:
        return None
    spread = float(runs.levels[-1] - runs.levels[0])
    whole = np.diff(runs.levels) / runs.step
    if np.abs(whole - np.rint(whole)).max() > 1e-3:
        return None  # a signal that repeats exactly has few values too
    bits = math.log2(spread / runs.step + 1.0)
    return FewSteps(count, runs.step, bits, runs.step / math.sqrt(12.0), signal.unit)
