"""Whether one start in a ball returns, by Krawczyk's operator, and how large its multipliers are.

Unknown are the start, the period without a drive, and a number where one is varied. To vanish are the gap of
the return, without a drive a phase, and where a number is varied the distance from a plane that cuts the
branch: with F of these, F' over the ball and about its inverse Y, each plane is met in exactly one point if
m - Y F(m) + (1 - Y F')(ball - m) lies inside the ball.
"""

import functools
from dataclasses import dataclass

from flint import acb, acb_mat, arb, arb_mat

from trimmer.proof.balls import about, between
from trimmer.proof.following import RADIUS, BallMotion, Followed, identity
from trimmer.proof.outcome import UndecidedError

MOST_ITERATIONS = 30
NOTHING = arb(1e-12)  # A modulus below this is told as between 0 and this: how wide balls are is no result


@dataclass(frozen=True)
class Plane:
    """What cuts a branch: the unknowns less a place, weighted, are a height."""

    place: list[arb]  # The unknowns somewhere on it
    weights: list[arb]  # One for each of them
    height: arb  # All heights for which a statement holds

    def distance(self, unknown: list[arb]) -> arb:
        """Return how far the unknowns are below it."""
        away = (w * (p - u) for w, p, u in zip(self.weights, self.place, unknown, strict=True))
        return self.height + sum(away, arb(0))


@dataclass(frozen=True)
class Returned:
    """What returns."""

    unknown: list[arb]  # Enclosed: start, what an unknown period is longer, and the number that is varied
    ball: list[arb]  # Around it, in which no other returns
    over: Followed  # The motion from all of the ball


def first_guess(motion: BallMotion) -> list[arb]:
    """Return the unknowns as computed."""
    start = [arb(each.mid()) for each in motion.start]
    return start + [arb(0)] * (motion.unknowns - motion.n)


def scales(motion: BallMotion) -> list[arb]:
    """Return the size of each unknown."""
    found = list(motion.sizes[: motion.n])
    if motion.autonomous:
        found.append(motion.segments[-1].duration)
    for along, _ in motion.shifts:
        found.append(
            max(
                (size / abs(way) for size, way in zip(motion.sizes, along, strict=False) if way != 0),
                key=float,
            )
        )
    return [*found, arb(1)][: motion.unknowns]


def solve(
    motion: BallMotion, plane: Plane | None = None, guess: list[arb] | None = None, radius: int = RADIUS
) -> Returned:
    """Find what returns, alone in a ball.

    Args:
        motion: The motion.
        plane: Of a family, what cuts it.
        guess: Where to begin; as computed if not given.
        radius: Power of two of the radius of the ball, as a share of the sizes.
    """
    middle = newton(motion, plane, guess, radius)
    radii = [each * arb(2) ** radius for each in scales(motion)]
    ball = [m + about(r) for m, r in zip(middle, radii, strict=True)]
    over = motion.follow(ball, True)
    derivative = derivative_of(motion, over, plane)
    inverse = inverse_of(derivative)
    image = _step(motion, motion.follow(middle), middle, plane, inverse)
    reaches = arb_mat([[about(each)] for each in radii])
    image = image + (identity(inverse.nrows()) - inverse * derivative) * reaches
    if not all(reaches[i, 0].contains_interior(image[i, 0]) for i in range(inverse.nrows())):
        raise UndecidedError("Krawczyk's operator does not map the ball of starts into itself")
    return Returned([each + image[i, 0] for i, each in enumerate(middle)], ball, over)


def newton(
    motion: BallMotion, plane: Plane | None = None, guess: list[arb] | None = None, radius: int = RADIUS
) -> list[arb]:
    """Find about what returns, by Newton's method, to less than the radius of a ball."""
    middle = guess or first_guess(motion)
    plane = plane and Plane(plane.place, plane.weights, arb(plane.height.mid()))
    inverse = inverse_of(derivative_of(motion, motion.follow(middle, True), plane))
    for _ in range(MOST_ITERATIONS):
        step = _step(motion, motion.follow(middle), middle, plane, inverse)
        middle = [arb((each + step[i, 0]).mid()) for i, each in enumerate(middle)]
        if all(
            abs(step[i, 0]) < each * arb(2) ** (radius - 20) or step[i, 0].contains(0)
            for i, each in enumerate(scales(motion))
        ):
            break
    return middle


def first_step(motion: BallMotion) -> list[arb]:
    """Return Newton's step from what was computed."""
    guess = first_guess(motion)
    followed = motion.follow(guess, True)
    step = _step(motion, followed, guess, None, inverse_of(derivative_of(motion, followed)))
    return [arb(each) for each in step.entries()]


def derivative_of(motion: BallMotion, followed: Followed, plane: Plane | None = None) -> arb_mat:
    """Return the derivative of what is to vanish."""
    table = [[each - int(i == k) for k, each in enumerate(row)] for i, row in enumerate(followed.change)]
    rest = [arb(0)] * (motion.unknowns - motion.n)
    table += [[*row, *rest] for row in _fixed(motion)]
    if plane is not None:
        table.append(plane.weights)
    return arb_mat(table)


def _fixed(motion: BallMotion) -> list[list[arb]]:
    """Return functionals of the start that stay as they are, since it may be shifted in time or in place."""
    return [*([motion.phase] if motion.autonomous else []), *(leader for _, leader in motion.shifts)]


def _step(
    motion: BallMotion, followed: Followed, middle: list[arb], plane: Plane | None, inverse: arb_mat
) -> arb_mat:
    """Return Newton's step."""
    gaps = [m - back for m, back in zip(middle, followed.back, strict=False)]
    for row in _fixed(motion):
        away = (p * (s - m) for p, s, m in zip(row, motion.start, middle, strict=False))
        gaps.append(sum(away, arb(0)))
    if plane is not None:
        gaps.append(plane.distance(middle))
    return inverse * arb_mat([[each] for each in gaps])


def inverse_of(derivative: arb_mat) -> arb_mat:
    """Return about the inverse of the middle of a matrix, exact as far as it goes."""
    try:
        return derivative.mid().inv().mid()
    except ZeroDivisionError:
        raise UndecidedError("1 is a multiplier, as near as balls tell") from None


def in_sizes(motion: BallMotion, over: Followed) -> arb_mat:
    """Return the derivative of the end by the start, as shares of the sizes."""
    sizes, n = motion.sizes, range(motion.n)
    return arb_mat([[over.change[i][k] * sizes[k] / sizes[i] for k in n] for i in n])


def multipliers_of(motion: BallMotion, over: Followed) -> tuple[bool | None, str]:
    """Enclose the largest modulus of the multipliers; return whether it is stable, and that in words."""
    sizes, n, scaled = motion.sizes, motion.n, in_sizes(motion, over)
    fixed = _fixed(motion)
    if fixed:
        # Without the shifts in time and place: along them, back to where what is fixed is that of the start.
        rates = (motion.segments[-1].flow * over.ends[-1]).entries()
        ways = [*([rates] if motion.autonomous else []), *(along for along, _ in motion.shifts)]
        along = arb_mat([[way[i] / sizes[i] for way in ways] for i in range(n)])
        kept = arb_mat([[row[i] * sizes[i] for i in range(n)] for row in fixed])
        scaled = scaled - along * (kept * along).inv() * (kept * scaled)
    lower, upper = _largest_modulus(scaled)
    stable = True if upper < 1 else False if lower > 1 else None
    return stable, between(arb(0), NOTHING) if upper < NOTHING else between(lower, upper)


def _largest_modulus(table: arb_mat) -> tuple[arb, arb]:
    """Bound the largest modulus of an eigenvalue, by Gershgorin's discs in about the eigenvectors."""
    size = range(table.nrows())
    vectors = acb_mat(table.mid()).eig(right=True, algorithm="approx")[1].mid()
    try:
        turned = vectors.solve(acb_mat(table) * vectors).tolist()
    except ZeroDivisionError:
        raise UndecidedError("the multipliers are not told, for want of eigenvectors") from None
    reaches = [about(sum((abs(turned[i][k]) for k in size if k != i), arb(0))) for i in size]
    discs = [turned[i][i] + acb(each, each) for i, each in enumerate(reaches)]
    # Discs that hang together hold as many eigenvalues as they are.
    inside: list[acb] = []
    around = [max(discs, key=lambda each: float(abs(each).mid()))]
    while len(inside) < len(around):
        inside = around
        around = [each for each in discs if any(each.overlaps(other) for other in inside)]
    moduli = [[abs(each) for each in group] for group in (inside, discs)]
    return functools.reduce(arb.min, moduli[0]).lower().max(arb(0)), functools.reduce(
        arb.max, moduli[1]
    ).upper()
