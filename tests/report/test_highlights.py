"""Sizes in the summary, against the response solved from mass, damping and stiffness matrices with NumPy."""

import numpy as np
import pytest

from report.highlights import highlights

M = np.diag([0.035, 0.003, 0.005, 0.030])  # thesis, listing A.1
K = 1e3 * np.array([[230, -30, 0, 0], [-30, 31, -1, 0], [0, -1, 251, -100], [0, 0, -100, 100]])
C = np.array([[3.9, -0.4, 0, 0], [-0.4, 0.4, 0, 0], [0, 0, 5, -4], [0, 0, -4, 4]])
PIN = np.array([-1, 1, 0, 0])
LIMIT_CYCLE = 2 * np.pi * 733.33  # thesis, table 5.1


def response(omega, sign=-1):
    motion = np.linalg.solve(-(omega**2) * M + 1j * omega * C + K, 30e3 * PIN)
    return motion[1] + sign * motion[3]


def ratio(omega, harmonic):
    return abs(response(harmonic * omega) / response(omega))


@pytest.fixture(scope="module")
def sizes(evidence):
    return {highlight.claim: highlight.size for highlight in highlights(evidence)}


def test_harmonics_of_the_drive(sizes):
    size = sizes["txt-5.1.3-first-resonance"]
    assert f"{ratio(2 * np.pi * 100, 5):.1f} times better at 100 Hz" in size
    assert f"{ratio(2 * np.pi * 109.945, 5):.0f} times at 109.945 Hz" in size
    assert f"passed {ratio(LIMIT_CYCLE, 3):.3f} times" in sizes["txt-5.1.2-filtering"]


def test_static_gains_of_the_two_outputs(sizes):
    wrong, right = response(0, sign=1).real, response(0).real
    assert sizes["eq-5.1"] == f"static gain {wrong:.4f} instead of {right:.4f}"


def test_cutoff_and_unit_gain(sizes):
    omega = np.arange(2300, 5200, 0.02)
    gain = np.abs([response(each) for each in omega])
    unity = omega[gain >= 1][-1]
    level = abs(response(0)) * 10 ** (-3 / 20)
    first, last = omega[gain <= level][0], omega[gain >= level][-1]
    for printed, found in zip(_numbers(sizes["txt-5.1.2-cutoff"]), (unity, 3, first, last), strict=True):
        assert printed == pytest.approx(found, abs=0.08)


def test_lost_amplitude_and_roll_off(sizes):
    assert sizes["eq-2.8"].startswith(f"{1 / 0.0015:.0f} times")
    fall = 20 * np.log10(abs(response(1e8) / response(1e7)))
    assert sizes["txt-5.1.2-roll-off"].startswith(f"−{-fall:.0f} dB")


def _numbers(text):
    words = (word.strip(";,") for word in text.split())
    return [float(word) for word in words if word.replace(".", "", 1).isdigit()]
