"""Harmonic balance of some samples, and how far it is from their exact orbits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.branches.balanced import balanced_beside
from trimmer.contact.flow import MechanismFlow
from trimmer.maps.inputs import varied
from trimmer.maps.settle import settle
from trimmer.mechanism.mechanism import Mechanism

if TYPE_CHECKING:
    from trimmer.arrays import Flags, Reals
    from trimmer.uncertainty.samples import Samples

HARMONICS = 15  # Harmonics of the drive up to which forces balance


@dataclass(frozen=True, eq=False)
class BalancedSamples:
    """Harmonic balance beside the exact orbits of some samples.

    Attributes:
        numbers: Which of the trials, shape (m,).
        distances: Root mean square of the difference from the exact displacements as a share of these, of
            the body where it is largest, shape (m,).
        converged: Whether the forces balance, shape (m,).
        harmonics: Harmonics of the drive up to which they balance.
    """

    numbers: tuple[int, ...]
    distances: Reals
    converged: Flags
    harmonics: int


def balanced_samples(samples: Samples, count: int) -> BalancedSamples:
    """Balance the forces of the first samples whose motion repeats, up to ``HARMONICS``."""
    repeating = [at for at, trial in enumerate(samples.trials) if trial.period_count is not None]
    numbers, distances, converged = [], [], []
    for at in repeating[:count]:
        values = samples.trials[at].values
        mechanism = varied(samples.inputs.subject, samples.inputs.uncertainty.places, values)
        assert isinstance(mechanism, Mechanism)
        flow = MechanismFlow.returning(mechanism)
        orbit = settle(flow, flow.rest(), samples.inputs.settings.most_periods).orbit
        if orbit is None:
            continue
        found = balanced_beside(orbit.course, flow.mechanism, orbit.periods, HARMONICS)
        numbers.append(at)
        distances.append(found.distance)
        converged.append(found.converged)
    return BalancedSamples(tuple(numbers), np.array(distances), np.array(converged, dtype=bool), HARMONICS)
