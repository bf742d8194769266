"""Results of harmonic balance: limit cycles, and how far it is certain that there are no others."""

from __future__ import annotations

import math
from dataclasses import dataclass

NEAR_TANGENCY = math.radians(5.0)
"""Crossing angle, rad, below which a limit cycle is reported as near tangency."""


@dataclass(frozen=True)
class LimitCycle:
    """A solution of 1 + N(A, omega) G(j omega) = 0 (equation 2.25 of the thesis).

    Attributes:
        amplitude: Half of peak to peak at the input of the element, in the unit of that input.
        omega: Angular frequency, rad/s.
        stable: Whether a small change dies out: Loeb's criterion holds for the amplitude, and there are no
            other unstable poles. See ``trimmer.balance.stability`` for what that does not cover.
        residual: |1 + N G| as computed.
        crossing_angle: Angle between the curves N (rising amplitude) and -1/G (rising frequency), rad, from 0
            to pi/2, with N taken as it changes with frequency too.
        index: 1 where Loeb's criterion holds, -1 where not: the sign of the Jacobian determinant of 1 + N G
            over ln A and ln omega.
        other_unstable_poles: Number of poles of the loop with N frozen that lie in the right half plane at
            positive frequencies, without the pair of the limit cycle itself, and of positive real ones of
            the loop of its mean.
    """

    amplitude: float
    omega: float
    stable: bool
    residual: float
    crossing_angle: float
    index: int
    other_unstable_poles: int

    @property
    def frequency(self) -> float:
        """Frequency of the limit cycle, Hz."""
        return self.omega / (2.0 * math.pi)

    @property
    def near_tangency(self) -> bool:
        """Whether the curves nearly touch: neither existence nor stability can then be trusted.

        The harmonics that harmonic balance drops move the curves by more than what parts them.
        """
        return self.crossing_angle < NEAR_TANGENCY


@dataclass(frozen=True)
class UndecidedRegion:
    """Amplitudes and frequencies about which nothing is proven: a tangency, or a continuum of solutions.

    Attributes:
        amplitudes: Smallest and largest amplitude, in the unit of the element's input; may be infinite.
        omegas: Smallest and largest angular frequency, rad/s.
    """

    amplitudes: tuple[float, float]
    omegas: tuple[float, float]


@dataclass(frozen=True)
class Certificate:
    """How far it is certain that no limit cycle was missed.

    Attributes:
        method: How it was ascertained, in words.
        omegas: Angular frequencies that were searched, rad/s.
        outside_excluded: Whether it is proven too that no limit cycle has a frequency outside that range.
        boxes: Number of boxes examined.
        undecided: Regions about which nothing is proven.
        smallest_gain: Limit cycles with |N| below this, in the unit of N, were not looked for, and are not
            excluded either. 0 if none can exist; more where N vanishes at the edge of a dead band while |G|
            is not bounded, as with an integrator in G.
        winding_number: Turns of 1 + N G along the border of what was searched, an independent check: it must
            be the sum of the indices. None if it cannot be computed, as where G has a zero on the axis.
    """

    method: str
    omegas: tuple[float, float]
    outside_excluded: bool
    boxes: int
    undecided: tuple[UndecidedRegion, ...]
    smallest_gain: float
    winding_number: int | None

    @property
    def complete(self) -> bool:
        """Whether every part of the range that was searched is decided."""
        return not self.undecided


@dataclass(frozen=True)
class HarmonicBalance:
    """All limit cycles of a loop, and the certificate.

    Attributes:
        limit_cycles: In order of frequency, then of amplitude.
        certificate: How far it is certain that there are no others.
    """

    limit_cycles: tuple[LimitCycle, ...]
    certificate: Certificate

    @property
    def confirmed(self) -> bool | None:
        """Whether the winding number is the sum of the indices; None if there is no winding number."""
        if self.certificate.winding_number is None:
            return None
        return self.certificate.winding_number == sum(cycle.index for cycle in self.limit_cycles)

    @property
    def success(self) -> bool:
        """Whether every part of the range is decided, and the winding number contradicts nothing."""
        return self.certificate.complete and self.confirmed is not False

    @property
    def message(self) -> str:
        """What came out, in words."""
        found = f"{len(self.limit_cycles)} limit cycle{'' if len(self.limit_cycles) == 1 else 's'} found"
        if self.confirmed is False:
            return f"{found}, which the winding number contradicts: do not rely on it"
        undecided = len(self.certificate.undecided)
        if undecided:
            return f"{found}; others may lie in {undecided} undecided region{'' if undecided == 1 else 's'}"
        return f"{found}, and no other is in the range that was searched"
