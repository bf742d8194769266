"""Forces at several multiples of the drive on one body: all that is told of it is known in closed form."""

import math

import numpy as np
import pytest

from tests.trimmer.response.test_solved import OMEGA, oscillator
from trimmer import Force, Mechanism, MotionKind, respond

CONSTANT = 0.2
SINES = {1: (0.5, 0.3), 3: (8.0, 1.2), 25: (3.0, -0.4)}
"""Amplitude and phase of the force, N and rad, by multiple of the drive."""
MOVED = {order: force / (1 - (order * OMEGA) ** 2) for order, (force, _) in SINES.items()}
"""Amplitude of the forced displacement, m, in phase with the force."""
TIMES = np.linspace(0.0, 2 * math.pi / OMEGA, 100_001)
DRIVEN = sum(MOVED[order] * np.sin(order * OMEGA * TIMES + phase) for order, (_, phase) in SINES.items())


def forced() -> Mechanism:
    forces = {f"of order {n}": Force("body", 0.0, force, phase, n) for n, (force, phase) in SINES.items()}
    forces["weight"] = Force("body", CONSTANT)
    return oscillator(forces=forces)


def test_undamped_motion_is_told_exactly() -> None:
    """From rest the free vibration takes away the place and the velocity of the forced one."""
    response = respond(forced())
    motion, name = response.motion, "body"
    free = math.hypot(CONSTANT + DRIVEN[0], sum(n * OMEGA * MOVED[n] * math.cos(SINES[n][1]) for n in SINES))
    sizes = {n: abs(amplitude) for n, amplitude in MOVED.items()}
    assert response.kind is MotionKind.TORUS
    assert (motion.lyapunov.value, motion.events_per_period, motion.advance[name]) == (0.0, 0.0, 0.0)
    assert motion.mean[name] == pytest.approx(CONSTANT, rel=1e-12)
    expected = [sizes.get(n, 0.0) for n in range(1, len(motion.harmonics[name]) + 1)]
    assert motion.harmonics[name] == pytest.approx(expected, rel=1e-11)
    assert motion.peak_to_peak[name] == pytest.approx(np.ptp(DRIVEN) + 2 * free, rel=1e-5)
    parts = {1 / OMEGA: free, **sizes}
    rms = math.sqrt(0.5 * sum(each**2 for each in parts.values()))
    faster = math.sqrt(0.5 * sum(((n * OMEGA) ** 2 * each) ** 2 for n, each in parts.items()))
    assert motion.rms[name].value == pytest.approx(rms, rel=1e-11)
    assert motion.rms_acceleration[name].value == pytest.approx(faster, rel=1e-11)
    assert response.box[name] == pytest.approx(
        (CONSTANT + sum(parts.values()), sum(n * OMEGA * each for n, each in parts.items())), rel=1e-11
    )
