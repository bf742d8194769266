"""Results of harmonic balance: limit cycles, and how far it is certain that there are no others."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from trimmer.showing.drawn import Drawn, drawn
from trimmer.showing.shown import Shown, ShownFields, Tabular, counted
from trimmer.showing.table import Table, attributes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.loops.loops import ClosedLoop
    from trimmer.loops.measured_loop import MeasuredLoop

NEAR_TANGENCY = math.radians(5.0)
"""Crossing angle, rad, below which a limit cycle is reported as near tangency."""


@dataclass(frozen=True)
class LimitCycle(ShownFields):
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
class UndecidedRegion(ShownFields):
    """Amplitudes and frequencies about which nothing is proven: a tangency, or a continuum of solutions.

    Attributes:
        amplitudes: Smallest and largest amplitude, in the unit of the element's input; may be infinite.
        omegas: Smallest and largest angular frequency, rad/s.
        at_edge: Whether the smallest amplitude at which the element has a steady output is among them, or
            so near that rounding does not tell.
    """

    amplitudes: tuple[float, float]
    omegas: tuple[float, float]
    at_edge: bool = False

    @property
    def reason(self) -> str:
        """Why nothing is proven, in words."""
        if self.at_edge:
            return "-1/G meets N where N ends, as near as can be told, at the smallest amplitude"
        return "the curves of N and -1/G touch or coincide there"


def doubts_of_search(undecided: Sequence[UndecidedRegion], smallest_gain: float) -> tuple[str, ...]:
    """Say why a search may have missed limit cycles, in sentences without a full stop."""
    return (*_doubts_of_regions(undecided), *_doubts_of_gain(smallest_gain))


def _doubts_of_regions(undecided: Sequence[UndecidedRegion]) -> Iterator[str]:
    for region in undecided:
        lowest, highest = region.omegas
        yield (
            f"undecided between {lowest:.9g} and {highest:.9g} rad/s: {region.reason}, and limit cycles in "
            "that range may be missing from the list"
        )


def _doubts_of_gain(smallest_gain: float) -> Iterator[str]:
    if smallest_gain > 0:
        yield (
            f"limit cycles with |N| below {smallest_gain:.3g} are not excluded, next to a pole of G on the "
            "imaginary axis; give an omega_range that keeps away from that pole"
        )


@dataclass(frozen=True, repr=False)
class Certificate(Shown):
    """How far it is certain that no limit cycle was missed.

    Attributes:
        method: How it was ascertained, in words.
        omegas: Angular frequencies that were searched, rad/s.
        outside_excluded: Whether it is proven too that no limit cycle has a frequency outside that range.
        boxes: Number of boxes examined.
        undecided: Regions about which nothing is proven.
        smallest_gain: Limit cycles with |N| below this were not looked for, and are not excluded either. 0 if
            none can exist; more where N vanishes at the edge of a dead band while |G| is not bounded, as with
            a pole of G on the imaginary axis about whose neighbourhood nothing is proven.
        winding_number: Turns of 1 + N G along the border of all amplitudes and ``winding_omegas``, an
            independent check: it must be the sum of the indices. None if it cannot be determined.
        index_sum: Sum of the indices of the limit cycles that were found.
        zero_on_axis: Whether G has a zero on the imaginary axis in the range. Then 1/G is infinite there, and
            the winding number cannot be determined.
        unproven: What is not proven because the element has no bounds, or because what the system was given
            by does not tell its poles and zeros, in sentences without a full stop.
        winding_omegas: Angular frequencies between which the winding number counts, rad/s. They follow from
            the coefficients of G, not from the search, unless the range was given or the coefficients do not
            tell them. None if it was not asked for, as where the element has no bounds.
    """

    method: str
    omegas: tuple[float, float]
    outside_excluded: bool
    boxes: int
    undecided: tuple[UndecidedRegion, ...]
    smallest_gain: float
    winding_number: int | None
    index_sum: int
    zero_on_axis: bool
    unproven: tuple[str, ...] = ()
    winding_omegas: tuple[float, float] | None = None

    @property
    def checked(self) -> bool:
        """Whether the winding number is the sum of the indices, or known why it cannot be determined."""
        if self.winding_number is None:
            return self.zero_on_axis
        return self.winding_number == self.index_sum

    @property
    def complete(self) -> bool:
        """Whether no limit cycle is missing: all is decided, nothing is left out, the check holds."""
        return not self.doubts

    @property
    def doubts(self) -> tuple[str, ...]:
        """Why limit cycles may be missing, in sentences without a full stop; none if it is complete."""
        return (*_doubts_of_regions(self.undecided), *self.other_doubts)

    @property
    def other_doubts(self) -> tuple[str, ...]:
        """The doubts that are about no undecided region."""
        doubts = (*self.unproven, *_doubts_of_gain(self.smallest_gain))
        # Where something is undecided the winding number may well lack what is there.
        return doubts if self.checked or self.undecided or self.unproven else (*doubts, self._failed_check())

    def _told(self) -> str:
        lowest, highest = self.omegas
        answer = "complete" if self.complete else "not complete"
        undecided = counted(len(self.undecided), "undecided region")
        return f"{answer}, {lowest:.4g} to {highest:.4g} rad/s, {undecided}"

    def _failed_check(self) -> str:
        if self.winding_number is None:
            return (
                "the winding number that is to check the list cannot be told, so a limit cycle may be missing"
            )
        return (
            f"the winding number is {self.winding_number} and the sum of the indices {self.index_sum}, so a "
            "limit cycle is missing from the list"
        )


@dataclass(frozen=True)
class InterpolationBound(ShownFields):
    """How far a limit cycle may be off because G is known at some frequencies alone, to first order.

    The response is relative (``trimmer.linear.measured_response``), the amplitude in the unit of the
    element's input, omega in rad/s.
    """

    response: float
    amplitude: float
    omega: float


IN_UNIT_OF_INPUT = "unit of the element's input"  # Stands for the unit of an amplitude; m for a play
CYCLE_COLUMNS = attributes(
    amplitude=IN_UNIT_OF_INPUT,
    omega="rad/s",
    frequency="Hz",
    stable="",
    residual="",
    crossing_angle="rad",
    near_tangency="",
    other_unstable_poles="",
)


@dataclass(frozen=True, repr=False)
class HarmonicBalance(Tabular, Drawn):
    """All limit cycles of a loop, and the certificate.

    Attributes:
        limit_cycles: In order of frequency, then of amplitude.
        certificate: How far it is certain that there are no others.
        loop: The loop, with the element as it was solved for; None if the result was put together by hand.
        bounds: Of frequency-response data, how far off each limit cycle may be; else empty.
    """

    limit_cycles: tuple[LimitCycle, ...]
    certificate: Certificate
    loop: ClosedLoop | MeasuredLoop | None = field(default=None, compare=False)
    bounds: tuple[InterpolationBound, ...] = ()

    @property
    def confirmed(self) -> bool | None:
        """Whether the winding number is the sum of the indices; None if there is no winding number."""
        if self.certificate.winding_number is None:
            return None
        return self.certificate.winding_number == sum(cycle.index for cycle in self.limit_cycles)

    @property
    def success(self) -> bool:
        """Whether no limit cycle is missing, as far as the search went: see ``certificate``."""
        return self.certificate.complete and self.confirmed is not False

    @property
    def message(self) -> str:
        """What came out, in words."""
        found = f"{len(self.limit_cycles)} limit cycle{'' if len(self.limit_cycles) == 1 else 's'} found"
        return "; ".join(
            [found, *(self.certificate.doubts or ["no other is in the range that was searched"])]
        )

    def plot(self, ax: Axes | None = None, *, near: bool = False) -> Axes:
        """Draw G(j omega) and -1/N in the complex plane, with the limit cycles: full stable, open not.

        Args:
            ax: Where to draw; new axes if not given.
            near: Show only what lies around the limit cycles and -1.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
            ValueError: if the result has no loop.
        """
        return drawn(self, ax, near=near)

    def _told(self) -> str:
        return self.message

    def _table(self) -> Table:
        return Table("Limit cycles", self.limit_cycles, CYCLE_COLUMNS)
