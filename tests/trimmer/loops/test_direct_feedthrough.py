"""A linear system that passes a part of its input on at once: y = C x + D v."""

import math

import control
import numpy as np
import pytest

from trimmer import Drive, FrictionBacklash, OpenLoop, ViscousBacklash, simulate
from trimmer.elements import Element

GAP = 0.1
DRIVE = Drive(0.3, 2.0 * math.pi)
TIMES = np.linspace(0.0, 3.0, 301)


def system(direct: float) -> control.StateSpace:
    """Two damped modes beside what passes at once."""
    A = np.array([[0.0, 1.0, 0.0], [-30.0, -0.8, 0.0], [0.0, 0.0, -2.0]])
    return control.ss(A, [[0.0], [5.0], [1.0]], [[1.0, 0.1, -0.4]], [[direct]])


@pytest.mark.parametrize("element", [2.0 * FrictionBacklash(GAP), ViscousBacklash(GAP, 0.05)])
def test_a_driven_system_adds_the_element_output_times_d(element: Element) -> None:
    """The element follows the drive alone, so the outputs differ by D times its output."""
    motions = [simulate(OpenLoop(system(d), element, DRIVE), 3.0) for d in (0.0, 0.7)]
    added = motions[1].output(TIMES) - motions[0].output(TIMES)
    passed = motions[1].element_output(TIMES)
    assert np.ptp(passed) > GAP
    assert added == pytest.approx(0.7 * passed, abs=1e-12)
    assert motions[1].state(TIMES) == pytest.approx(motions[0].state(TIMES), abs=1e-12)
