"""Stable periodic motions of random loops by brute force: small fixed steps, from many states."""

from collections.abc import Iterator
from dataclasses import dataclass

from tests.trimmer.orbits.peer_time_stepping import PeerLoop, final_amplitude
from tests.trimmer.orbits.random_loops import RandomLoop

STARTS = 8
DURATION = 300.0  # In units of the time constants, which are about one
STEP = 1e-3
FINER = 8
ALIKE = 1e-2  # Difference of two amplitudes, relative, below which they are the same


@dataclass(frozen=True)
class Sustained:
    """A periodic motion: its amplitude by steps, by finer steps, and whether that is one that is known."""

    coarse: float
    fine: float
    known: bool


def sustained(loop: RandomLoop, known: list[float]) -> Iterator[Sustained]:
    """Yield periodic motions that random initial states lead to.

    The finer steps are taken only if the others lead to no known amplitude. What they make much smaller is no
    motion of the loop but that of the steps, as where a relay slides.
    """
    peer = PeerLoop.of(loop.system.A, loop.system.B, loop.system.C, loop.element)
    for _ in range(STARTS):
        start = loop.generator.normal(size=loop.system.nstates) * 10.0 ** loop.generator.uniform(-1.0, 1.5)
        coarse = final_amplitude(peer, start, STEP, DURATION)
        if coarse is None:
            continue
        if _near(coarse, known):
            yield Sustained(coarse, coarse, True)
            continue
        fine = final_amplitude(peer, start, STEP / FINER, DURATION)
        if fine is not None and fine > 0.5 * coarse:
            yield Sustained(coarse, fine, _near(fine, known) or _tends(coarse, fine, known))


def _near(amplitude: float, known: list[float]) -> bool:
    return any(abs(amplitude - each) < ALIKE * each for each in known)


def _tends(coarse: float, fine: float, known: list[float]) -> bool:
    """Whether the finer steps come at least twice as near to a known amplitude, and near enough."""
    return any(abs(fine - each) < min(0.5 * abs(coarse - each), 5 * ALIKE * each) for each in known)
