"""Random loops with integrators and large gains against a grid that is fine at the edge of the domain."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer.balance.solve import harmonic_balance
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash
from trimmer.linear.frequency_response import response_at


def random_loop(random: np.random.Generator) -> tuple[control.TransferFunction, Element]:
    """Up to three integrators, gains up to 1e5, no resonance that a grid would step over."""
    denominator = np.poly1d([1.0, *[0.0] * random.integers(0, 4)])
    for _ in range(random.integers(1, 4)):
        omega, damping = 10 ** random.uniform(-1, 1), 10 ** random.uniform(-1.4, 0.3)
        pair = random.random() < 0.6
        denominator *= np.poly1d([1, 2 * damping * omega, omega**2] if pair else [1, omega])
    numerator = np.poly1d([random.choice([-1, 1]) * 10 ** random.uniform(-1, 5)])
    for _ in range(random.integers(0, max(1, denominator.order))):
        numerator *= np.poly1d([1, random.choice([-1, 1], p=[0.2, 0.8]) * 10 ** random.uniform(-1, 1)])
    elements = (
        FrictionBacklash(1.0),
        ViscousBacklash(1.0, 10 ** random.uniform(-4, 2)),
        InertiaBacklash(1.0),
    )
    return control.tf(numerator.coeffs, denominator.coeffs), elements[random.choice(3, p=[0.5, 0.35, 0.15])]


def solutions_next_to_the_edge_too(
    G: control.TransferFunction, element: Element, omegas: tuple[float, float]
) -> int:
    """Count the cells of a grid round which 1 + N G turns; it ends at 1 - 1e-11 of the largest scale/A."""
    omega = np.geomspace(*omegas, 3000)
    share = np.concatenate([np.geomspace(1e-6, 0.5, 150), 1 - np.geomspace(0.5, 1e-11, 300)[1:]])
    amplitude = element.amplitude_scale / (share[:, None] * element.domain(omega))
    gain = element.describing_function(amplitude, np.broadcast_to(omega, amplitude.shape))
    phase = np.angle(1.0 + gain * response_at(G, omega))
    corners = (phase[:-1, :-1], phase[1:, :-1], phase[1:, 1:], phase[:-1, 1:])
    steps = (end - start for start, end in zip(corners, (*corners[1:], corners[0]), strict=True))
    turns = np.rint(sum((step + np.pi) % (2 * np.pi) - np.pi for step in steps) / (2 * np.pi))
    return int(np.abs(turns).sum())


def check(seed: int, loops: int) -> None:
    random = np.random.default_rng(seed)
    compared = 0
    for _ in range(loops):
        G, element = random_loop(random)
        balance = harmonic_balance(G, element)
        if balance.certificate.complete:
            lowest, highest = balance.certificate.omegas
            expected = solutions_next_to_the_edge_too(G, element, (0.5 * lowest, 2.0 * highest))
            assert len(balance.limit_cycles) == expected, (G, element)
            compared += 1
    assert compared >= 0.9 * loops


def test_as_many_as_on_a_grid_for_some_loops() -> None:
    check(11, 12)


@pytest.mark.slow
def test_as_many_as_on_a_grid_for_300_loops() -> None:
    check(12, 300)
