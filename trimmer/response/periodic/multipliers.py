"""Floquet multipliers of a return, and by how much rounding may have moved each."""

import numpy as np
import scipy.linalg
from scipy.linalg import lapack

from trimmer.arrays import Complexes, Reals
from trimmer.motion.flow import Flow
from trimmer.response.periodic.shooting import CLOSED, Return, Shot

FAR = 0.5  # Modulus of a multiplier below which it is far inside the unit circle, whatever its rounding
ROUNDING = 64 * float(np.finfo(float).eps)
"""Rounding of the derivative of a return in each of its segments, as a share of its norm."""

NEAR = 1e-3  # Distance of a multiplier from 1 below which the return hardly tells where the orbit is
MISPLACED = 4.0  # By how many times its estimate an orbit may be misplaced


def multipliers_of(shot: Shot) -> tuple[Complexes, Reals]:
    """Return the eigenvalues of the derivative of a return, by falling modulus, and their rounding."""
    felt = shot.course.modes.system.layout.independent
    matrix = shot.monodromy * shot.sizes / shot.sizes[:, None]
    if len(felt) < len(matrix):
        matrix = matrix[np.ix_(felt, felt)]
    if not np.isfinite(matrix).all():
        raise np.linalg.LinAlgError("the derivative of the return is not finite")
    values = np.linalg.eigvals(matrix).astype(complex)
    values = values[np.argsort(-abs(values), kind="stable")]
    rounding = ROUNDING * (1 + len(shot.course.events)) + min(shot.miss, CLOSED)
    margins, largest = np.zeros(len(values)), abs(values).max(initial=0.0)
    for each, condition in zip(*_conditions(matrix), strict=True) if len(values) else ():
        nearest = np.argmin(abs(values - each) + (margins > 0) * largest)
        margins[nearest] = rounding * condition
    return values, margins


def with_place(flow: Flow, shot: Shot, periods: int, multipliers: Complexes, margins: Reals) -> Reals:
    """Return the margins with what the place of the orbit adds to them.

    Where a multiplier is near 1 the return hardly tells where along its direction the orbit is: the miss is
    divided by the distance from 1. So it is where slips die away, each with a smaller one to follow: their
    derivatives approach 1 as the slips approach none, and Newton's method stops on the way.

    Args:
        flow: The motion of the mechanism.
        shot: The orbit.
        periods: Number of drive periods that it spans; without a drive, 0, the margins stay as they are.
        multipliers: By falling modulus, (n,).
        margins: Rounding of each, (n,).
    """
    distance = abs(multipliers - 1)
    near = np.flatnonzero((distance < NEAR) & (multipliers.imag == 0) & (distance > margins))
    if not periods or not len(near):
        return margins
    found, begin, matrix = (
        margins.copy(),
        shot.course.begin,
        shot.monodromy * shot.sizes / shot.sizes[:, None],
    )
    values, vectors = np.linalg.eig(matrix)
    for each in near:
        direction = vectors[:, np.argmin(abs(values - multipliers[each]))].real
        missed = shot.miss + ROUNDING * np.linalg.norm(matrix)
        step = MISPLACED * missed / distance[each] * direction / abs(direction).max()
        for misplaced in (step, -step):
            start = flow.at(begin.state + misplaced * shot.sizes, begin.phase, like=begin)
            beside = Return(flow, periods).shoot(start, sizes=shot.sizes)
            moved = np.inf if beside is None else abs(multipliers_of(beside)[0] - multipliers[each]).min()
            found[each] = max(found[each], moved)
    return found


def _conditions(matrix: Reals) -> tuple[Complexes, Reals]:
    """Return the eigenvalues that may be near the unit circle, and their conditions times the norm.

    Those far inside, of which stick and contact make many at zero that cannot be told apart, are split off by
    a projection first (Golub and Van Loan, Matrix Computations, 2013, section 7.2). The units are such that
    rows and columns are of one size: sizes at events say little where there are few.
    """
    # LAPACK itself: what SciPy checks about it takes longer than these small matrices.
    balanced = lapack.dgebal(matrix, scale=1, permute=0)[0]
    schur, count = _sorted_schur(balanced)
    large, rest, beside = schur[:count, :count], schur[count:, count:], schur[:count, count:]
    solution, scale = lapack.ztrsyl(large, rest, beside, isgn=-1)[:2] if beside.size else (beside, 1.0)
    lean = float(np.linalg.norm(solution / scale))
    values, vectors = np.linalg.eig(large)
    try:
        left = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        return values, np.full(count, np.inf)
    conditions = np.linalg.norm(left, axis=1) * np.linalg.norm(vectors, axis=0)
    return values, conditions * np.hypot(1.0, lean) * np.linalg.norm(balanced)


def _sorted_schur(matrix: Reals) -> tuple[Complexes, int]:
    """Return a complex Schur form with the large eigenvalues first, and their number."""
    for far in (FAR, 0.8 * FAR, 1.2 * FAR):  # One that lies just there cannot be sorted.
        found = lapack.zgees(
            lambda value, far=far: abs(value) >= far, matrix.astype(complex), compute_v=0, sort_t=1
        )
        schur, count, *_, info = found
        if info == 0:
            return schur, count
    return scipy.linalg.schur(matrix, output="complex")[0], len(matrix)
