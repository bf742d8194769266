"""The proof of incremental dissipation as a step: a driven trimmer with dry friction forgets its start."""

import sympy

from derivations.algebra.identity import UnprovenError
from derivations.elements.incremental_dissipation import incremental_dissipation
from derivations.latex import latex
from derivations.linear_trimmer import LinearTrimmer
from derivations.step import Formula, NarrativeStep


def dissipation_step(trimmer: LinearTrimmer) -> NarrativeStep:
    """Return the proof.

    Raises:
        UnprovenError: if the balance of the difference does not close or one of its terms can be negative.
    """
    proof = incremental_dissipation(trimmer)
    if not proof.holds:
        raise UnprovenError("two motions of the trimmer with the same pin are not proven to come together")
    size = trimmer.matrices.mass.rows
    damping, stiffness = proof.leading_minors[size : 2 * size], proof.leading_minors[2 * size :]
    return NarrativeStep("dissipation", _TITLE, _TEXT, (*_balance(), *_minors(damping, stiffness)), _CODE)


def _balance() -> tuple[Formula, ...]:
    return (
        Formula(
            r"E = \frac{1}{2} \dot{d}^{\mathsf{T}} M \dot{d} + \frac{1}{2} d^{\mathsf{T}} K d, \quad "
            r"d = q_a - q_b"
        ),
        Formula(
            r"\frac{dE}{dt} = -\dot{d}^{\mathsf{T}} C \dot{d} - \sum (f_a - f_b)(w_a - w_b)",
            words="The equations of the two motions are subtracted and multiplied by $\\dot d$. The pin's "
            "terms are the same in both and cancel. Here $w$ is the relative velocity in a friction and $f$ "
            "its force; the sum is over all frictions.",
        ),
        Formula(
            r"(f_a - f_b)(w_a - w_b) = \begin{cases} 0 & \text{both slide the same way, or both stick} \\ "
            r"2 F_c (|w_a| + |w_b|) & \text{they slide opposite ways} \\ "
            r"(F_c - |f_b|)\, |w_a| \text{ or more} & \text{one slides, the other sticks} \end{cases}",
            words="No term of the sum is negative, because the friction force never falls as the velocity "
            "rises. A sticking friction carries any force from $-F_c$ to $F_c$.",
        ),
    )


def _minors(damping: tuple[sympy.Expr, ...], stiffness: tuple[sympy.Expr, ...]) -> tuple[Formula, ...]:
    """Return the leading principal minors that make C and K positive definite, all but the longest."""
    shown = ((name, minors[:3]) for name, minors in (("C", damping), ("K", stiffness)))
    words = (
        "The quadratic forms are positive, by Sylvester's criterion: the determinants of the upper left "
        "corners are sums of products of positive parameters, of which the first three are",
        "",
    )
    return tuple(
        Formula(
            r", \quad ".join(rf"\left|{name}_{{{size}}}\right| = {latex(sympy.factor(minor))}"
                             for size, minor in enumerate(minors, start=1)),
            words=said,
        )
        for (name, minors), said in zip(shown, words, strict=True)
    )  # fmt: skip


_TITLE = "Why a driven trimmer with friction forgets its start"
_TEXT = (
    "Two motions $a$ and $b$ of one trimmer have the same pin and dry friction, and start differently. Their "
    "difference $d$ moves freely, without a pin, and its energy $E$ can only fall.\n\n"
    "$E$ falls as long as $\\dot d$ is not zero, and it is not negative, so $\\dot d$ tends to zero: in the "
    "end all motions have the same velocities. Motions stay bounded, so by Brouwer's theorem one of them "
    "has the pin's period $T$, and all others end in its velocities. If the pin changes its sign after half "
    "a period, $u(t + T/2) = -u(t)$, that motion turned over and shifted by half a period is a motion too, "
    "so it is the same one: it has odd harmonics only, none between them, and no limit cycle beside it.\n\n"
    "This holds for play that only passes a displacement on, as in the thesis's loop opened at the pin: "
    "what comes out of such play is another periodic displacement. It does not hold where the load pushes "
    "back through the play."
)
_CODE = (incremental_dissipation,)
