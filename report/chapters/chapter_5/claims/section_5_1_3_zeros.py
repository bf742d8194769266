"""Claim of section 5.1.3 on antiresonances, which figures 5.2 and 5.4 show for different outputs."""

from __future__ import annotations

import math

import control
import numpy as np
from numpy.typing import NDArray

from report.chapters.chapter_5.claims.section_5_1_3 import READING_ACCURACY
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.light_damping import lightly_damped, sum_of_displacements
from trimmer import InputChannels, TrimmerParameters, linear_model, transfer_function

Reals = NDArray[np.float64]

OUTPUT = np.array([0.0, 1.0, 0.0, -1.0])
"""Weights of the four displacements in the output of the thesis's loop, q2 - q4."""
SUM = np.ones(4)
"""Weights of the four displacements in the output of figure 5.4 (equation 5.3)."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    parameters = evidence.numbers.parameters
    light = lightly_damped(parameters)
    outputs = {
        "figure 5.2": evidence.numbers.displacement_only,
        "figure 5.4": sum_of_displacements(light),
        "figure 5.2, lightly damped": transfer_function(light, channels=InputChannels.DISPLACEMENT_ONLY),
    }
    first, other, undamped = (_antiresonances(system) for system in outputs.values())
    shift = _farthest(first, undamped)
    without = _zeros_without_damping(parameters, OUTPUT)
    return (
        Claim(
            id="txt-5.1.3-antiresonances",
            parts=(
                _same_place(parameters, first, other),
                Part(
                    "damping itself, for one output",
                    Assertion(
                        statement="damping does not move the antiresonances, as far as a plot can be read",
                        derived=shift < READING_ACCURACY,
                        evidence=f"those of $q_2 - q_4$ move by {100 * shift:.2f} % at most",
                        method="zeros with all and with a thousandth of the damping",
                    ),
                    Confirmation(
                        "frequencies where a constrained system without damping is free to swing",
                        CloseNumbers(float(without[1]), float(undamped[1]), 1e-4),
                    ),
                ),
            ),
            explanation=(
                "Resonances belong to the system, antiresonances to the output that is looked at. Figure 5.4 "
                "shows the sum of all displacements, figure 5.2 a difference of two, so their valleys may "
                f"not be compared: the one near {first[1]:.0f} rad/s is at {other[1]:.0f} rad/s there. That "
                "damping hardly moves them is right, but only for one and the same output."
            ),
            consequence="None: no later number uses an antiresonance.",
            impact=Impact.LOCAL,
            source="report/numbers/light_damping.py",
        ),
    )


def _same_place(parameters: TrimmerParameters, first: Reals, other: Reals) -> Part:
    second = _zeros_without_damping(parameters, SUM)
    return Part(
        "figure 5.4 beside figure 5.2",
        Assertion(
            statement="the antiresonances of the two figures are the same, as far as a plot can be read",
            derived=_farthest(first, other) < READING_ACCURACY,
            evidence=(
                f"at {_listed(first)} rad/s in figure 5.2 and {_listed(other)} rad/s in figure 5.4, up to "
                f"{100 * _farthest(first, other):.1f} % apart"
            ),
            method="zeros of the two transfer functions; a plot is read to 1 %",
        ),
        Confirmation(
            "frequencies where a constrained system without damping is free to swing",
            CloseNumbers(float(second[1]), float(other[1]), 1e-4),
        ),
    )


def _antiresonances(system: control.TransferFunction) -> Reals:
    """Return the imaginary parts of the zeros, rising, rad/s."""
    zeros = np.roots(system.num[0][0])
    return np.sort(zeros.imag[zeros.imag > 0])


def _zeros_without_damping(parameters: TrimmerParameters, weights: Reals) -> Reals:
    """Return where an output of the undamped system stays zero, from its mass and stiffness matrices, rad/s.

    There (K - ω² M) q = F p with w·q = 0: a bordered matrix without inverse.
    """
    model = linear_model(parameters)
    flow, force = np.asarray(model.A)[4:, :4], np.asarray(model.B)[4:, :1]
    omegas = np.linspace(100.0, 9000.0, 20_000)
    bordered = np.zeros((omegas.size, 5, 5))
    bordered[:, :4, :4] = -flow - omegas[:, None, None] ** 2 * np.eye(4)
    bordered[:, :4, 4:], bordered[:, 4, :4] = force, weights
    values = np.linalg.det(bordered)
    places = np.flatnonzero(np.diff(np.sign(values)))
    share = values[places] / (values[places] - values[places + 1])
    return omegas[places] + share * (omegas[places + 1] - omegas[places])


def _farthest(first: Reals, other: Reals) -> float:
    return float(np.abs(other / first - 1).max()) if first.size == other.size else math.inf


def _listed(omegas: Reals) -> str:
    return ", ".join(f"{omega:.0f}" for omega in omegas)
