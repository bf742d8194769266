"""The formulas of the short derivation, evaluated as they stand there."""

import math

import numpy as np

from report.overview.short import short
from trimmer import TrimmerParameters


def test_its_formulas_hold_at_the_limit_cycles_it_names(evidence) -> None:
    p = TrimmerParameters.thesis()
    mass = np.diag([p.m1, p.m2, p.m3, p.m4])
    coil, joint = np.zeros((4, 4)), np.zeros((4, 4))
    coil[1:3, 1:3] = joint[2:, 2:] = [[1, -1], [-1, 1]]
    bridge = np.zeros((4, 4))
    bridge[:2, :2] = [[1, -1], [-1, 1]]
    stiffness = np.diag([p.k1, 0, p.k3, 0]) + p.k2 * bridge + p.k5 * coil + p.k4 * joint
    damping = np.diag([p.c1, 0, p.c3, 0]) + p.c2 * bridge + p.c4 * joint
    for cycle in (evidence.cycles.friction.unstable, evidence.cycles.friction.stable):
        s = 2j * math.pi * cycle.frequency
        response = np.linalg.solve(mass * s**2 + damping * s + stiffness, p.k2 * np.array([-1, 1, 0, 0]))
        psi = math.asin(1 - 1 / cycle.amplitude)
        n = (math.pi / 2 + psi + math.sin(psi) * math.cos(psi) - 1j * math.cos(psi) ** 2) / math.pi
        assert abs(1 + n * (response[1] - response[3])) < 1e-9


def test_it_names_both_limit_cycles_and_the_exact_orbit(evidence) -> None:
    said = " ".join(
        [step.text + "".join(e.words + e.latex for e in step.equations) for step in short(evidence)]
    )
    assert all(number in said for number in ("8.3152", "733.63", "8.2895", "733.57"))
