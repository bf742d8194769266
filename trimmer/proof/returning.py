"""Whether one start in a ball returns, by Krawczyk's operator, and how large its multipliers are.

Unknown are the start, the period without a drive, and a number where one is varied. To vanish are the gap of
the return, without a drive a phase, and where a number is varied the distance from a plane that cuts the
branch: with F of these, F' over the ball and about its inverse Y, each plane is met in exactly one point if
m - Y F(m) + (1 - Y F')(ball - m) lies inside the ball.
"""

import functools
from dataclasses import dataclass, replace
from typing import Self

from flint import acb, acb_mat, arb, arb_mat

from trimmer.proof.balls import about, between, krawczyk
from trimmer.proof.following import RADIUS, BallMotion, Followed
from trimmer.proof.outcome import UndecidedError

MOST_ROUNDS = 20  # Of Newton's method
ALIKE = "1 is a multiplier, as near as balls tell"
NEAR = 1e-9
"""Distance from the computed motion, as a share of the size of each state, within which it is that."""
NOTHING = arb(1e-12)  # A modulus below this is told as between 0 and this: how wide balls are is no result


@dataclass(frozen=True)
class Plane:
    """What cuts a branch: the unknowns less a place, weighted, are a height."""

    place: list[arb]  # The unknowns somewhere on it
    weights: list[arb]  # One for each of them
    height: arb  # All heights for which a statement holds

    def at(self, height: arb) -> Self:
        """Return the plane, or all planes, of a height."""
        return replace(self, height=height)

    def distance(self, unknown: list[arb]) -> arb:
        """Return how far the unknowns are below it."""
        away = (w * (p - u) for w, p, u in zip(self.weights, self.place, unknown, strict=True))
        return self.height + sum(away, arb(0))


@dataclass(frozen=True)
class Returned:
    """What returns: from which ball of unknowns, in which no other does, and how."""

    ball: list[arb]  # Of starts, of what an unknown period is longer, and of the number that is varied
    unknown: list[arb]  # The same more narrowly
    over: Followed  # The motion from all of the ball


def first_guess(motion: BallMotion) -> list[arb]:
    """Return the unknowns as computed."""
    return [*motion.start, *[arb(0)] * (motion.unknowns - motion.n)]


def scales(motion: BallMotion) -> list[arb]:
    """Return the size of each unknown."""
    period = [motion.segments[-1].duration] * motion.autonomous
    return [*motion.sizes[: motion.n], *period, arb(1)][: motion.unknowns]


def solve(
    motion: BallMotion,
    plane: Plane | None = None,
    guess: list[arb] | None = None,
    radius: int = RADIUS,
    known: Followed | None = None,
) -> Returned:
    """Find what returns, alone in a ball, and enclose it there.

    Args:
        motion: The motion.
        plane: Of a family, what cuts it.
        guess: Where to begin; as computed if not given.
        radius: Power of two of the radius of the ball, as a share of the sizes.
        known: The motion from there with its derivative, if it has been followed.
    """
    middle = newton(motion, plane, guess, radius, known)
    ball = [m + about(r * arb(2) ** radius) for m, r in zip(middle, scales(motion), strict=True)]
    over = motion.follow(ball, True)
    image = _image(motion, plane, ball, over)
    if not all(each.contains_interior(part) for each, part in zip(ball, image, strict=True)):
        raise UndecidedError("Krawczyk's operator does not map the ball of starts into itself")
    return Returned(ball, image, over)


def narrowed(motion: BallMotion, plane: Plane, found: Returned) -> Returned:
    """Enclose what of a ball returns more narrowly, on one of the planes for which it was found."""
    for _ in range(3):
        ball = _image(motion, plane, found.ball, found.over)
        over = motion.follow(ball, True)
        found = Returned(ball, ball, over)
    return found


def _image(motion: BallMotion, plane: Plane | None, ball: list[arb], over: Followed) -> list[arb]:
    """Return the image of a ball by Krawczyk's operator, which holds all in it that return."""
    middle = [arb(each.mid()) for each in ball]
    try:
        return krawczyk(
            ball, _lacking(motion, motion.follow(middle), middle, plane), derivative_of(motion, over, plane)
        )
    except ZeroDivisionError:
        raise UndecidedError(ALIKE) from None


def newton(
    motion: BallMotion, plane: Plane | None, guess: list[arb] | None, radius: int, known: Followed | None
) -> list[arb]:
    """Find about what returns, by Newton's method, to less than the radius of a ball."""
    middle = guess or first_guess(motion)
    plane = plane and plane.at(arb(plane.height.mid()))
    fine = [size * arb(2) ** (radius - 20) for size in scales(motion)]
    for _ in range(MOST_ROUNDS):
        middle, step = nearer(motion, plane, middle, known or motion.follow(middle, True))
        known = None
        if all(abs(each) < size or each.contains(0) for each, size in zip(step, fine, strict=True)):
            break
    return middle


def nearer(
    motion: BallMotion, plane: Plane | None, middle: list[arb], over: Followed
) -> tuple[list[arb], list[arb]]:
    """Take two of Newton's steps with the derivative before the first; return the second too.

    They give three times as many digits. To follow a motion without its derivative costs a fraction of that.
    """
    inverse = inverse_of(derivative_of(motion, over, plane))
    for _ in range(2):
        step = _step(motion, middle, plane, inverse)
        middle = [arb((m + each).mid()) for m, each in zip(middle, step, strict=True)]
    return middle, step


def require_alone(motion: BallMotion) -> Followed:
    """Tell a family: what stays where it is put, although Newton's step from there is long.

    Returns:
        The motion as computed, with its derivative.
    """
    guess, sizes = first_guess(motion), scales(motion)
    over = motion.follow(guess, True)
    gaps = zip(over.back, guess, sizes, strict=False)
    if all(abs(end - begin) < NEAR * size for end, begin, size in gaps):
        step = _step(motion, guess, None, inverse_of(derivative_of(motion, over)))
        if any(abs(each) > NEAR * size for each, size in zip(step, sizes, strict=True)):
            raise UndecidedError("1 is a multiplier, to the digits of the motion: it may be one of a family")
    return over


def derivative_of(motion: BallMotion, followed: Followed, plane: Plane | None = None) -> arb_mat:
    """Return the derivative of what is to vanish."""
    table = [[each - int(i == k) for k, each in enumerate(row)] for i, row in enumerate(followed.change)]
    if motion.autonomous:
        table.append([*motion.phase, *[arb(0)] * (motion.unknowns - motion.n)])
    if plane is not None:
        table.append(plane.weights)
    return arb_mat(table)


def _lacking(motion: BallMotion, followed: Followed, middle: list[arb], plane: Plane | None) -> list[arb]:
    """Return what is lacking of zero of what is to vanish."""
    gaps = [m - back for m, back in zip(middle, followed.back, strict=False)]
    if motion.autonomous:
        away = (p * (s - m) for p, s, m in zip(motion.phase, motion.start, middle, strict=False))
        gaps.append(sum(away, arb(0)))
    return gaps if plane is None else [*gaps, plane.distance(middle)]


def _step(motion: BallMotion, middle: list[arb], plane: Plane | None, inverse: arb_mat) -> list[arb]:
    """Return Newton's step."""
    lacking = _lacking(motion, motion.follow(middle), middle, plane)
    step: list[arb] = (inverse * arb_mat([[each] for each in lacking])).entries()
    return step


def inverse_of(derivative: arb_mat) -> arb_mat:
    """Return about the inverse of the middle of a matrix, exact as far as it goes."""
    try:
        return derivative.mid().inv().mid()
    except ZeroDivisionError:
        raise UndecidedError(ALIKE) from None


def in_sizes(motion: BallMotion, over: Followed) -> arb_mat:
    """Return the derivative of the end by the start, as shares of the sizes."""
    sizes, n = motion.sizes, range(motion.n)
    return arb_mat([[over.change[i][k] * sizes[k] / sizes[i] for k in n] for i in n])


def multipliers_of(motion: BallMotion, over: Followed) -> tuple[bool | None, str]:
    """Enclose the largest modulus of the multipliers; return whether it is stable, and that in words."""
    sizes, n, scaled = motion.sizes, motion.n, in_sizes(motion, over)
    if motion.autonomous:
        # Without the shift in time: along the rates, back to where what is fixed is that of the start.
        rates = (motion.segments[-1].flow * over.ends[-1]).entries()
        along = arb_mat([[rates[i] / sizes[i]] for i in range(n)])
        kept = arb_mat([[motion.phase[i] * sizes[i] for i in range(n)]])
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
