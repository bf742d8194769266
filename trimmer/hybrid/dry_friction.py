"""Dry friction at several contacts at once: what can hold, what begins to slide, and in which direction.

The relative velocities of m contacts are v = D u, with the velocities u of the bodies. The contacts act on
the bodies with -Dᵀ f, where f_i = F_i sign(v_i) while contact i slides, and |f_i| <= F_i while it sticks
(static and kinetic friction are equal). The bodies' masses M give the relative accelerations w = b - Γ f,
with b those without friction, and the influence Γ = D M⁻¹ Dᵀ, which is symmetric and positive semidefinite.

**Holding.** All contacts that stick hold if w = 0. That fixes the resultant Dᵀ f of the forces, but f itself
only if the rows of D are independent; in a ring of three bodies they are not. The resultants of all f within
the limits fill a zonotope, and each of its facets is a row of inequalities

    |y · f| <= Σ |y_i| F_i,    y = D n with as few entries unequal to zero as possible.

These y are the elementary vectors of the column space of D (Rockafellar 1969). Their products y · f do not
depend on the split, so they can be formed with any f that gives the resultant, such as the smallest. An
admissible split exists if and only if all inequalities hold, and where f is linear in the state they are too.
So the end of stick is the first zero of finitely many linear functions of the state.

**Sliding.** The motion obeys a differential inclusion with a maximal monotone right-hand side, so it is
unique (Filippov 1988; Leine and Nijmeijer 2004), although the split is not. Where the resultant leaves the
zonotope through the facet of y, the contacts with y_i ≠ 0 begin to slide, contact i with the sign of y_i;
just these are at their limit in every admissible split. The others stay together. Where the resultant lies
outside, because a force has jumped, the accelerations follow from the linear complementarity problem

    w = b - Γ f,    lower <= f <= upper,    f_i = upper_i if w_i > 0,    f_i = lower_i if w_i < 0

(Lötstedt 1982; Pfeiffer and Glocker 1996). It says that f minimises ½ f·Γf - b·f between the bounds; so w is
unique. Where all accelerations of some contacts are zero and a facet is touched, the same problem for the
rates decides: contacts that are at their limit may only go back from it, the others are not bounded.

References:
    R. T. Rockafellar, The elementary vectors of a subspace of R^N, in Combinatorial Mathematics and its
    Applications, University of North Carolina Press 1969. P. Lötstedt, Mechanical systems of rigid bodies
    subject to unilateral constraints, SIAM J. Appl. Math. 42, 1982. F. Pfeiffer and Ch. Glocker, Multibody
    Dynamics with Unilateral Contacts, Wiley 1996. R. I. Leine and H. Nijmeijer, Dynamics and Bifurcations
    of Non-Smooth Mechanical Systems, Springer 2004. A. F. Filippov, Differential Equations with
    Discontinuous Righthand Sides, Kluwer 1988. C. L. Lawson and R. J. Hanson, Solving Least Squares
    Problems, Prentice-Hall 1974.
"""

from itertools import combinations

import numpy as np

from trimmer.arrays import Flags, Integers, Reals

DEPENDENT = 1e-10  # A direction that lies so close to the span of others, relative to its length, lies in it
ROUNDING = 1e-12  # An acceleration below this share of the moduli of its terms is zero
AT_EDGE = 1e-9  # A resultant that is outside what can be held by less than this share of it is at its edge

MOST_STEPS = 50
"""Steps for each unknown, after which a complementarity problem is given up; some per unknown are usual."""


def elementary_vectors(directions: Reals) -> Reals:
    """Return the vectors with the fewest entries unequal to zero in the column space of a matrix.

    Args:
        directions: D, of shape (m, n): one row for each contact. Lengths of rows count; a row of zeros is not
            allowed.

    Returns:
        Array (k, m), one of each pair of opposite vectors; the first entry unequal to zero is positive, and
        the largest modulus one. If the rows of D are independent, they are the m unit vectors, in order.
    """
    lengths = np.linalg.norm(directions, axis=1)
    unit = directions / lengths[:, None]
    left, values, _ = np.linalg.svd(unit, full_matrices=False)
    rank = _rank(values)
    basis = left[:, :rank]
    if rank == len(directions):
        return np.eye(rank)
    found: dict[tuple[int, ...], Reals] = {}
    for rows in combinations(range(len(directions)), rank - 1):
        # The vector of the column space that is zero in these rows, if they leave just one.
        across = np.ones((1, 1))
        if rank > 1:
            _, sizes, across = np.linalg.svd(basis[list(rows)])
            if sizes[-1] <= DEPENDENT:
                continue
        vector = basis @ across[-1]
        vector = np.where(abs(vector) > DEPENDENT, vector * lengths, 0.0)
        support = tuple(np.flatnonzero(vector).tolist())
        if support not in found:
            found[support] = vector / np.copysign(abs(vector).max(), vector[support[0]])
    return np.array([found[support] for support in sorted(found)])


def independent(directions: Reals) -> Integers:
    """Return the numbers of rows that span the space of all: each that those before it do not span, in order.

    Args:
        directions: D, (m, n).
    """
    if len(directions) == 1:
        return np.flatnonzero(directions.any(axis=1))
    chosen: list[int] = []
    basis = np.zeros((0, directions.shape[1]))
    for number, direction in enumerate(directions):
        left, length = direction, np.linalg.norm(direction)
        for _ in range(2):  # The second time takes away what rounding has left of the basis.
            left = left - (basis @ left) @ basis
        if np.linalg.norm(left) > DEPENDENT * length:
            chosen.append(number)
            basis = np.vstack([basis, left / np.linalg.norm(left)])
    return np.array(chosen, dtype=np.intp)


def closure(directions: Reals, held: Flags) -> Flags:
    """Return which contacts stick, because their velocities follow from those that are held, or are these.

    Args:
        directions: D, of shape (m, n).
        held: Of shape (m,): contacts whose velocities are zero.
    """
    unit = directions / np.linalg.norm(directions, axis=1)[:, None]
    _, values, across = np.linalg.svd(unit[held], full_matrices=False)
    span = across[: _rank(values)]
    left_over = unit - unit @ span.T @ span
    return np.asarray(held | (np.linalg.norm(left_over, axis=1) <= DEPENDENT))


def margins(vectors: Reals, limits: Reals, forces: Reals) -> Reals:
    """Return how far the resultant of forces is inside each facet, relative to its distance from zero.

    All are >= 0 if and only if an admissible split exists, that is forces with the same resultant within the
    limits. The smallest one is the share by which the limits could be reduced.

    Args:
        vectors: ``elementary_vectors`` of the contacts, (k, m).
        limits: F > 0, (m,).
        forces: Any forces with the resultant, (m,).

    Returns:
        Array (k,).
    """
    bounds = abs(vectors) @ limits
    inside: Reals = 1.0 - abs(vectors @ forces) / bounds
    return inside


def admissible_split(
    directions: Reals, limits: Reals, forces: Reals, pushing: Flags | None = None
) -> Reals | None:
    """Return the admissible split with the least sum of squares of the forces relative to their limits.

    It is unique, and continuous in the resultant. Where the limits do not matter it is a linear function of
    the resultant; otherwise it is found as a problem of least distance (Lawson and Hanson 1974, chapter 23).

    Args:
        directions: D, (m, n).
        limits: F > 0, (m,).
        forces: Any forces with the resultant, (m,).
        pushing: Which contacts are walls: their forces have no limit, but are not negative, (m,). ``limits``
            only measures them.

    Returns:
        Forces within the limits, (m,), or None if there are none.
    """
    walls = np.zeros(len(limits), dtype=bool) if pushing is None else pushing
    shares = _shares_within(directions, limits, forces, walls)
    if shares is None and walls.any():
        # Beside forces of walls that are far larger rounding hides what frictions can hold.
        limits = np.where(walls, abs(forces).max(), limits)
        shares = _shares_within(directions, limits, forces, walls)
    if walls.any():
        return None if shares is None else np.maximum(shares, np.where(walls, 0.0, -1.0)) * limits
    if shares is None:
        # Rounding may have put the resultant outside a facet that it touches.
        share = 1.0 - float(margins(elementary_vectors(directions), limits, forces).min())
        if share > 1.0 + AT_EDGE:
            return None
        inside = (1.0 - AT_EDGE / 10) / max(share, 1.0)
        shares = _shares_within(directions, limits, inside * forces, walls)
        if shares is None:
            return None
        shares = shares / inside
    admissible: Reals = np.clip(shares, -1.0, 1.0) * limits
    return admissible


def _shares_within(directions: Reals, limits: Reals, forces: Reals, walls: Flags) -> Reals | None:
    """Return the least shares of the limits that are at most 1, up to rounding; None if there are none."""
    least, free = least_shares(directions, limits, forces)
    lowest, highest = np.where(walls, 0.0, -1.0), np.where(walls, np.inf, 1.0)
    if ((least < lowest) | (least > highest)).any():
        # The smallest z with free z >= lowest - least and -free z >= least - highest.
        below = np.column_stack([free, lowest - least])
        above = np.column_stack([-free, least - highest])[~walls]
        distance = _least_distance(np.vstack([below, above]))
        if distance is None:
            return None
        least = least + free @ distance
    off = np.maximum(lowest - least, least - highest)
    return None if (off > np.sqrt(ROUNDING)).any() else least


def least_shares(directions: Reals, limits: Reals, forces: Reals) -> tuple[Reals, Reals]:
    """Return the split with the least sum of squares of the forces relative to their limits, whatever these.

    Args:
        directions: D, (m, n).
        limits: F > 0, (m,).
        forces: Any forces with the resultant, (m,) or (m, columns).

    Returns:
        The forces as shares of the limits, in the shape of ``forces``, and an orthonormal basis of the shares
        that have no resultant, (m, free): without columns if the resultant determines the split.
    """
    left, values, _ = np.linalg.svd(directions)
    scale = limits.reshape(-1, *(1,) * (forces.ndim - 1))
    free, _ = np.linalg.qr(left[:, _rank(values) :] / limits[:, None])
    shares: Reals = forces / scale
    return shares - free @ (free.T @ shares), free


def _least_distance(conditions: Reals) -> Reals | None:
    """Return the shortest z with conditions[:, :-1] z >= conditions[:, -1]; None if there is none."""
    lengths = np.linalg.norm(conditions, axis=1)
    unit = conditions[lengths > 0] / lengths[lengths > 0, None]
    multipliers, _ = complementary_forces(
        unit @ unit.T, unit[:, -1], np.zeros(len(unit)), np.full(len(unit), np.inf)
    )
    rest: Reals = multipliers @ unit
    rest[-1] -= 1.0
    return -rest[:-1] / rest[-1] if rest[-1] < -np.sqrt(ROUNDING) else None


def complementary_forces(
    influence: Reals, drift: Reals, lower: Reals, upper: Reals, noise: Reals | float = 0.0
) -> tuple[Reals, Reals]:
    """Solve w = drift - influence f with lower <= f <= upper, where w_i pushes f_i against its bound.

    The contacts whose force is between its bounds are collected one by one, as in the method of Lawson and
    Hanson (1974, chapter 23): each step lowers ½ f·Γf - b·f, and no set of them comes twice; so it ends after
    finitely many steps, and the influence of the collected ones on each other is positive definite.

    Args:
        influence: Γ, (m, m), symmetric and positive semidefinite, its diagonal positive.
        drift: b, (m,), in the column space of Γ.
        lower: Lower bounds, (m,), possibly minus infinity.
        upper: Upper bounds, (m,), possibly infinity.
        noise: What else is known of the rounding of b: a smaller acceleration is zero.

    Returns:
        A force f, of which only Γ f is unique, and w, (m,) each; w is exactly zero where it is rounding.

    Raises:
        ArithmeticError: if rounding keeps the method from ending.
    """
    size = np.sqrt(influence.diagonal())
    influence, drift = influence / np.outer(size, size), drift / size
    lower, upper, noise = lower * size, upper * size, noise / size
    forces = np.clip(0.0, lower, upper)
    between = np.zeros(len(drift), dtype=bool)
    for _ in range(MOST_STEPS * (len(drift) + 1)):
        left = drift - influence @ forces
        left[abs(left) <= noise + ROUNDING * (abs(drift) + abs(influence) @ abs(forces))] = 0.0
        left[between] = 0.0
        wrong = np.where(left > 0, forces < upper, forces > lower) & (left != 0.0)
        if not wrong.any():
            return forces / size, left * size
        between[int(np.argmax(np.where(wrong, abs(left), 0.0)))] = True
        forces, between = _with_zero_acceleration(influence, drift, (lower, upper), forces, between)
    raise ArithmeticError("the complementarity problem of the frictions was not solved")


def _with_zero_acceleration(
    influence: Reals, drift: Reals, bounds: tuple[Reals, Reals], forces: Reals, between: Flags
) -> tuple[Reals, Flags]:
    """Move the forces between their bounds to where they balance; one that meets a bound stays there."""
    (lower, upper), between, forces = bounds, between.copy(), forces.copy()
    while between.any():
        others = drift[between] - influence[np.ix_(between, ~between)] @ forces[~between]
        step, ends = _step_to_balance(influence[np.ix_(between, between)], others, forces[between])
        room = np.where(step > 0, upper[between] - forces[between], lower[between] - forces[between])
        nearer = abs(step) > (abs(room) if ends else 0.0)
        shares = np.divide(room, step, out=np.full(len(step), np.inf), where=nearer)
        share = float(shares.min())
        if share >= 1.0 and ends:
            forces[between] += step
            return forces, between
        forces[between] += share * step
        stopped = np.flatnonzero(between)[shares <= share]
        forces[stopped] = np.where(step[shares <= share] > 0, upper[stopped], lower[stopped])
        between[stopped] = False
    return forces, between


def _step_to_balance(influence: Reals, wanted: Reals, forces: Reals) -> tuple[Reals, bool]:
    """Return the change of forces after which they balance, and whether there is one.

    Where contacts depend on each other and what they touch moves differently, no forces balance. Then the
    change is a direction in which the accelerations stay as they are until a force meets its bound.
    """
    try:
        factor = np.linalg.cholesky(influence)
    except np.linalg.LinAlgError:
        factor = np.zeros_like(influence)
    if len(influence) and (factor.diagonal() ** 2 > DEPENDENT).all():
        return np.linalg.solve(influence, wanted) - forces, True
    values, vectors = np.linalg.eigh(influence)
    idle = vectors[:, values <= DEPENDENT * values.max()]
    left_over: Reals = idle @ (idle.T @ wanted)
    if (abs(left_over) > np.sqrt(ROUNDING) * abs(wanted).max()).any():
        left_over[abs(left_over) <= ROUNDING * abs(left_over).max()] = 0.0
        return left_over, False
    return np.linalg.pinv(influence, rcond=DEPENDENT) @ (wanted - influence @ forces), True


def _rank(values: Reals) -> int:
    return int((values > DEPENDENT * values.max(initial=0.0)).sum())
