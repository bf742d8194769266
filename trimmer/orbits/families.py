"""Orbits that are members of a continuum: one stands for all of them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.ties import levels

BRIEF = 1e-6
"""Share of a period below which a phase is a touch: Newton's method finds an orbit to the square of it."""


@dataclass(frozen=True)
class OrbitFamily:
    """A continuum of orbits, as of a relay that drives a double integrator, which keeps any amplitude.

    Attributes:
        member: The largest of those that were met; it stands for all.
        met: How many were met.
        amplitudes: Smallest and largest amplitude of these, in the unit of the element's input, m.
    """

    member: PeriodicOrbit
    met: int
    amplitudes: tuple[float, float]

    @property
    def sentence(self) -> str:
        """What it is, in words, without a full stop."""
        smallest, largest = self.amplitudes
        return (
            f"that of amplitude {largest:.6g} stands for a continuum, in which one lies beside the other "
            f"without end ({self.met} were met, with amplitudes from {smallest:.6g})"
        )


def by_families(orbits: Sequence[PeriodicOrbit]) -> tuple[tuple[PeriodicOrbit, ...], tuple[OrbitFamily, ...]]:
    """Return orbits by falling amplitude with one for each continuum, and the continua.

    Two orbits are of one continuum if both have neighbours in one, and as many events in a period. So is one
    at which it ends, where a play just touches. One that was met alone stays an orbit among others: it may be
    where two orbits meet.
    """
    members: dict[int, list[PeriodicOrbit]] = {}
    for orbit in orbits:
        events, touches = len(orbit.switching_times), _touches(orbit)
        if orbit.has_neighbours or (touches and orbit.edge is not None and orbit.edge.growth == 0.0):
            members.setdefault(events - 2 * touches, []).append(orbit)
    families = tuple(
        OrbitFamily(
            max(met, key=lambda orbit: orbit.amplitude),
            len(met),
            (min(orbit.amplitude for orbit in met), max(orbit.amplitude for orbit in met)),
        )
        for met in members.values()
        if len(met) > 1
    )
    left_out = {id(orbit) for met in members.values() if len(met) > 1 for orbit in met}
    kept = [orbit for orbit in orbits if id(orbit) not in left_out]
    kept += [family.member for family in families]
    falling = np.argsort(levels([-orbit.amplitude for orbit in kept]), kind="stable")
    return tuple(kept[place] for place in falling.tolist()), families


def _touches(orbit: PeriodicOrbit) -> int:
    """Return how many phases last no longer than rounding makes them."""
    times = orbit.switching_times
    lasting = np.diff(times, append=times[:1] + orbit.period)
    return int((lasting < BRIEF * orbit.period).sum())
