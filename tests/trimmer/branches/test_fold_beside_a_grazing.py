"""The fold of the two masses and a stop that lies 6e-9 beside the grazing, by 30-digit arithmetic.

Written from the equations alone: between events the motion is a sum of exponentials and a steady vibration.
In the motion with one contact in a period its duration is given; all else is solved for, the frequency too.
"""

from __future__ import annotations

from collections.abc import Callable

import mpmath
import pytest

GAP, FORCE, STOP, DAMPING = 1, mpmath.mpf("0.1"), 100, mpmath.mpf("0.03")


def flow(contact: bool) -> mpmath.matrix:
    """Matrix of displacements and velocities."""
    stiffness = mpmath.matrix([[1, -1], [-1, 2]])
    matrix = mpmath.zeros(4)
    for i in range(2):
        matrix[i, i + 2] = 1
        for j in range(2):
            matrix[i + 2, j], matrix[i + 2, j + 2] = -stiffness[i, j], -DAMPING * stiffness[i, j]
    matrix[2, 0] -= STOP if contact else 0
    return matrix


def vibration(matrix: mpmath.matrix, omega: mpmath.mpf) -> mpmath.matrix:
    """Complex amplitudes under the force on the second mass."""
    force = mpmath.matrix([0, 0, 0, mpmath.mpc(FORCE)])
    return mpmath.lu_solve(1j * omega * mpmath.eye(4) - matrix, force)


class Piece:
    """The motion with the stop touched or not, from one time to another, under cos(omega t + phase)."""

    def __init__(self, contact: bool, omega: mpmath.mpf, phase: mpmath.mpf) -> None:
        matrix = flow(contact)
        push = mpmath.matrix([0, 0, STOP * GAP if contact else 0, 0])
        self.rest = -mpmath.lu_solve(matrix, push)
        self.steady, self.omega, self.phase = vibration(matrix, omega), omega, phase
        self.rates, self.shapes = mpmath.eig(matrix)

    def forced(self, time: mpmath.mpf) -> mpmath.matrix:
        turn = mpmath.expj(self.omega * time + self.phase)
        return mpmath.matrix([(self.steady[i] * turn).real + self.rest[i] for i in range(4)])

    def end(self, begin: mpmath.mpf, state: mpmath.matrix, end: mpmath.mpf) -> mpmath.matrix:
        shares = mpmath.lu_solve(self.shapes, (state - self.forced(begin)).apply(mpmath.mpc))
        grown = mpmath.matrix([shares[j] * mpmath.exp(self.rates[j] * (end - begin)) for j in range(4)])
        free = self.shapes * grown
        return mpmath.matrix([free[i].real for i in range(4)]) + self.forced(end)


def misses(duration: mpmath.mpf) -> Callable[..., list[mpmath.mpf]]:
    """What must vanish for a contact of a duration: at its end the distance, after the period the change."""

    def of(*unknowns: mpmath.mpf) -> list[mpmath.mpf]:
        second, first_rate, second_rate, phase, omega = unknowns
        begin = mpmath.matrix([GAP, second, first_rate, second_rate])
        released = Piece(True, omega, phase).end(mpmath.mpf(0), begin, duration)
        end = Piece(False, omega, phase).end(duration, released, 2 * mpmath.pi / omega)
        return [(released[0] - GAP) / duration, *(end - begin)]

    return of


@pytest.mark.slow
def test_the_fold_beside_the_grazing_is_there() -> None:
    with mpmath.workdps(30):
        free = flow(False)
        grazing = mpmath.findroot(lambda omega: abs(vibration(free, omega)[0]) - GAP, mpmath.mpf("0.6534401"))
        steady = vibration(free, grazing)
        phase = -mpmath.arg(steady[0])
        turned = [(steady[i] * mpmath.expj(phase)).real for i in range(4)]
        guess = [turned[1], mpmath.mpf("0.00064"), turned[3], phase, grazing]
        omegas = []
        for duration in ("0.0029", "0.0030", "0.0031"):
            guess = list(mpmath.findroot(misses(mpmath.mpf(duration)), guess, tol=1e-24))
            omegas.append(float(guess[4] - grazing))
        assert float(grazing) == pytest.approx(0.6534401404163, rel=1e-12)
        assert max(omegas) < 0.0
    bend, slope = omegas[0] - 2 * omegas[1] + omegas[2], 0.5 * (omegas[2] - omegas[0])
    assert bend > 0.0
    lowest = omegas[1] - 0.5 * slope**2 / bend
    assert float(grazing) + lowest == pytest.approx(0.6534401345, abs=5e-11)
    assert lowest == pytest.approx(-5.867e-9, rel=1e-3)
