"""Whether one start in a ball returns, by Krawczyk's operator, and how large its multipliers are."""

from __future__ import annotations

from flint import arb, arb_mat, fmpq

from trimmer.proof.balls import about, real
from trimmer.proof.following import RADIUS, Followed, Motion, identity, norm
from trimmer.proof.undecided import UndecidedError

MOST_ITERATIONS = 30


def solve(motion: Motion) -> tuple[list[arb], arb, Followed]:
    """Find the start that returns; return it, what the period is longer, and the motion from its ball.

    Raises:
        UndecidedError: if nothing is proven.
    """
    middle, longer = [arb(each.mid()) for each in motion.start], arb(0)
    inverse = _inverse(_derivative(motion, motion.follow(middle, longer, True)))
    for _ in range(MOST_ITERATIONS):
        step = _step(motion, motion.follow(middle, longer), middle, inverse)
        middle = [arb((each + step[i, 0]).mid()) for i, each in enumerate(middle)]
        if motion.autonomous:
            longer = arb((longer + step[motion.n, 0]).mid())
        if all(
            abs(step[i, 0]) < motion.sizes[i] * arb(2) ** (RADIUS - 20) or step[i, 0].contains(0)
            for i in range(motion.n)
        ):
            break
    reach = arb(2) ** RADIUS
    radii = [each * reach for each in motion.sizes[: motion.n]]
    ball = [each + about(radius) for each, radius in zip(middle, radii, strict=True)]
    at_last = motion.segments[-1].duration * reach if motion.autonomous else arb(0)
    over = motion.follow(ball, longer + about(at_last), True)
    derivative = _derivative(motion, over)
    inverse = _inverse(derivative)
    image = _step(motion, motion.follow(middle, longer), middle, inverse)
    rest = identity(inverse.nrows()) - inverse * derivative
    reaches = arb_mat([[about(each)] for each in [*radii, *([at_last] if motion.autonomous else [])]])
    image = image + rest * reaches
    if not all(reaches[i, 0].contains_interior(image[i, 0]) for i in range(inverse.nrows())):
        raise UndecidedError("Krawczyk's operator does not map the ball of starts into itself")
    found = [each + image[i, 0] for i, each in enumerate(middle)]
    return found, longer + image[motion.n, 0] if motion.autonomous else longer, over


def _derivative(motion: Motion, followed: Followed) -> arb_mat:
    """Return the derivative of what is to vanish: the gap of the return, and a phase without drive."""
    extra = int(motion.autonomous)
    table = [[followed.change[i, k] - int(i == k) for k in range(motion.n)] for i in range(motion.n)]
    if extra:
        rates = motion.segments[-1].flow * followed.ends[-1]
        table = [[*row, rates[i, 0]] for i, row in enumerate(table)]
        table.append([*motion.phase, arb(0)])
    return arb_mat(table)


def _step(motion: Motion, followed: Followed, middle: list[arb], inverse: arb_mat) -> arb_mat:
    """Return Newton's step."""
    gaps = [[each - followed.ends[-1][i, 0]] for i, each in enumerate(middle)]
    if motion.autonomous:
        away = (p * (s - m) for p, s, m in zip(motion.phase, motion.start, middle, strict=True))
        gaps.append([sum(away, arb(0))])
    return inverse * arb_mat(gaps)


def _inverse(derivative: arb_mat) -> arb_mat:
    """Return about the inverse of the middle of a matrix, exact as far as it goes."""
    try:
        return derivative.mid().inv().mid()
    except ZeroDivisionError:
        raise UndecidedError("1 is a multiplier, as near as balls tell") from None


def multipliers_of(motion: Motion, over: Followed) -> tuple[bool | None, str]:
    """Enclose the largest modulus of the multipliers: of A^k at least |trace|/n and at most the norm."""
    sizes, n = motion.sizes, motion.n
    change = arb_mat([[over.change[i, k] for k in range(n)] for i in range(n)])
    if motion.autonomous:
        # Without the shift in time: along the rates, back to where the phase is that of the start.
        rates = motion.segments[-1].flow * over.ends[-1]
        along = arb_mat([[rates[i, 0]] for i in range(n)])
        phase = arb_mat([motion.phase])
        change = change - along * (phase * change) * (1 / (phase * along)[0, 0])
    scaled = arb_mat([[change[i, k] * sizes[k] / sizes[i] for k in range(n)] for i in range(n)])
    least, most, power = arb(0), arb(2) ** 900, scaled
    for doubled in range(13):
        exponent = real(fmpq(1, 2**doubled))
        size, trace = norm(power), abs(power.trace()) / n
        if not (size > 0 and size < arb(2) ** 800 and size > arb(2) ** -800):
            break
        most = most.min(arb(size.upper()) ** exponent)
        if trace > 0:
            least = least.max(arb(trace.lower()) ** exponent)
        power = power * power
    stable = True if most < 1 else False if least > 1 else None
    # Rounded outwards by more than six digits leave out.
    lower, upper = float((least * (1 - arb(2) ** -17)).lower()), float((most * (1 + arb(2) ** -17)).upper())
    return stable, f"between {lower:.6g} and {upper:.6g}"
