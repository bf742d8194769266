"""Where several elements in a loop balance their first harmonics, roughly: places on a grid to begin from.

With E the inputs of the elements, E = G(j omega) N(|E|) E. At a frequency and an amplitude of one element
the others follow by iteration: E is an eigenvector of G N, and N is that of E. What is looked for is an
eigenvalue 1.
"""

from dataclasses import dataclass

import control
import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements import CoulombFriction, Element, Relay, ScaledElement, SumOfElements, ViscousFriction

OMEGAS, AMPLITUDES = 81, 41  # Places of the grid, in equal ratios
SMALLEST, LARGEST = 1e-2, 1e4  # Amplitudes over the natural scale of an element
ITERATIONS = 6  # How often amplitudes are put into N
NEAR = 0.7  # Distance of an eigenvalue from 1 up to which it is worth a start


@dataclass(frozen=True, eq=False)
class HarmonicStart:
    """First harmonics of inputs, (elements,), omega, rad/s, and how far the eigenvalue is from 1."""

    inputs: Complexes
    omega: float
    distance: float


def responses(plant: control.StateSpace, rows: list[int], columns: list[int], omegas: Reals) -> Complexes:
    """Return G(j omega) from some inputs to some outputs, (omegas, outputs, inputs)."""
    pencils = 1j * omegas[:, None, None] * np.eye(plant.nstates) - plant.A
    moved = np.linalg.solve(
        pencils, np.broadcast_to(plant.B[:, columns], (len(omegas), *plant.B[:, columns].shape))
    )
    return np.asarray(plant.C[rows] @ moved + plant.D[np.ix_(rows, columns)])


def gains(element: Element, amplitudes: Reals, omegas: Reals) -> Complexes:
    """Return N of an element whose frictions take a velocity, shaped as the arrays; 0 without output."""
    match element:
        case SumOfElements():
            return np.asarray(sum(gains(term, amplitudes, omegas) for term in element.terms))
        case ScaledElement():
            return element.factor * gains(element.element, amplitudes, omegas)
        case CoulombFriction():
            element = Relay(element.force)
        case ViscousFriction():
            return np.full(amplitudes.shape, complex(element.damping))
    found = element.describing_function(amplitudes, omegas if element.depends_on_frequency else None)
    return np.asarray(np.where(np.isfinite(found), found, 0.0))


def starts(
    plant: control.StateSpace,
    elements: tuple[Element, ...],
    places: tuple[list[int], list[int]],
    omega_range: tuple[float, float],
) -> list[HarmonicStart]:
    """Return where to begin, the nearest to a balance first, in a range of angular frequencies, rad/s."""
    omegas = np.geomspace(*omega_range, OMEGAS)
    G = responses(plant, *places, omegas)[:, None]
    found = []
    for number, element in enumerate(elements):
        amplitudes = element.amplitude_scale * np.geomspace(SMALLEST, LARGEST, AMPLITUDES)
        values, inputs = _eigenvalues(G, elements, number, amplitudes, omegas)
        for row, column in _minima(np.abs(values - 1.0)):
            distance = float(abs(values[row, column] - 1.0))
            found.append(HarmonicStart(inputs[row, column], float(omegas[row]), distance))
    return sorted(found, key=lambda each: each.distance)


def _eigenvalues(
    G: Complexes, elements: tuple[Element, ...], number: int, amplitudes: Reals, omegas: Reals
) -> tuple[Complexes, Complexes]:
    """Return the eigenvalue nearest to 1, (omegas, amplitudes), and the inputs, of which one is given."""
    shape = (len(omegas), len(amplitudes))
    inputs = np.ones((*shape, len(elements)), dtype=complex) * amplitudes[:, None]
    at = np.broadcast_to(omegas[:, None], shape)
    values = np.zeros(shape, dtype=complex)
    with np.errstate(all="ignore"):
        for _ in range(ITERATIONS):
            sizes = np.maximum(np.abs(inputs), np.finfo(float).tiny)
            N = np.stack([gains(each, sizes[..., k], at) for k, each in enumerate(elements)], axis=-1)
            every, vectors = np.linalg.eig(np.nan_to_num(G * N[..., None, :]))
            best = np.argmin(np.abs(every - 1.0), axis=-1)[..., None]
            values = np.take_along_axis(every, best, axis=-1)[..., 0]
            vector = np.take_along_axis(vectors, best[..., None], axis=-1)[..., 0]
            inputs = np.nan_to_num(vector / vector[..., number, None] * amplitudes[:, None])
    return np.asarray(values), np.asarray(inputs, dtype=complex)


def _minima(distance: Reals) -> list[tuple[int, int]]:
    """Return where a distance is small, and least among its neighbours."""
    padded = np.pad(distance, 1, constant_values=np.inf)
    beside = [
        padded[1 + row : 1 + row + distance.shape[0], 1 + column : 1 + column + distance.shape[1]]
        for row in (-1, 0, 1)
        for column in (-1, 0, 1)
        if row or column
    ]
    rows, columns = np.nonzero((distance < NEAR) & (distance <= np.min(beside, axis=0)))
    return list(zip(rows.tolist(), columns.tolist(), strict=True))
