"""Every contour of viscous-controlled backlash lies between those of friction and inertia."""

import sympy
from sympy import cos, pi, sin

from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash import CONTACT, SEPARATION
from derivations.elements.backlash_closed_forms import (
    friction_fundamental,
    general_fundamental,
    inertia_fundamental,
)
from derivations.elements.backlash_harmonics import CONTACT_ANGLE, DECAY, MEANINGS
from derivations.elements.proven_step import Equality, ProvenStep


def step() -> ProvenStep:
    """Return the step that encloses the contours of viscous-controlled backlash by those of its limits."""
    return ProvenStep(
        "df-contours",
        "Viscous contours lie between those of friction and inertia",
        _CURVE + _MAP,
        (*_friction(), *_inertia(), _end()),
        code=(friction_fundamental, inertia_fundamental, general_fundamental),
    )


def _friction() -> tuple[Equality, ...]:
    real, imaginary = sympy.re(friction_fundamental()), sympy.im(friction_fundamental())
    square = sin(CONTACT_ANGLE) ** 2
    return (
        Equality(
            r"\pi \frac{d}{d\ell} \operatorname{Re} N_1 \text{ (friction)}",
            2 * square,
            pi * real.diff(CONTACT_ANGLE),
        ),
        Equality(r"-\pi \operatorname{Im} N_1 \text{ (friction)}", square, -pi * imaginary),
    )


def _inertia() -> tuple[Equality, ...]:
    real, imaginary = sympy.re(inertia_fundamental()), sympy.im(inertia_fundamental())
    versine = total(1, -cos(CONTACT))
    return (
        Equality(r"-\pi \operatorname{Im} N_1 \text{ (inertia)}", versine**2, -pi * imaginary),
        Equality(
            r"\pi \operatorname{Re} N_1 \text{ (inertia)}",
            total(CONTACT_ANGLE, product(sin(CONTACT_ANGLE), total(2, cos(CONTACT_ANGLE)))),
            pi * real,
            given=((CONTACT_ANGLE, pi - CONTACT),),
        ),
        Equality(
            r"\pi \frac{d}{d\lambda} \operatorname{Re} N_1 \text{ (inertia)}",
            product(2 * cos(CONTACT), versine),
            pi * real.diff(CONTACT),
        ),
    )


def _end() -> Equality:
    return Equality(
        r"\left.N_1\right|_{\lambda = \pi}",
        -product(2 * sympy.I / pi, cos(SEPARATION) ** 2, total(1, DECAY)),
        general_fundamental().subs(MEANINGS).subs(CONTACT, SEPARATION + pi),
    )


_CURVE = (
    "Contours here are those of $N_1$ for $0 < \\lambda \\le \\pi$; all begin at $N_1 = 1$ for $\\lambda = "
    "0$. Those of friction and inertia and the piece of the imaginary axis between their ends, 0 and "
    "$-4j/\\pi$, make a closed curve. It does not cross itself: the real part of friction rises with "
    "$\\ell$, the imaginary part of inertia falls with $\\lambda = \\phi_c$, and both real parts are "
    "positive up to the end. Where the imaginary parts of the two are equal, $\\sin\\ell = 1 - "
    "\\cos\\lambda$ with the $\\ell$ of friction and the $\\lambda$ of inertia, so $\\lambda \\le \\pi/2$; "
    "there the real part of inertia is not below 1, that of friction not above, and both are 1 only at the "
    "common beginning.\n\n"
)
_MAP = (
    "The contour of a load with $0 < \\gamma < \\infty$ ends at $\\lambda = \\pi$ on that piece of the axis, "
    "because $\\cos^2\\phi_s (1 + E)$ lies between 0 and 2. So $N_1$, which is continuous on the closed "
    "rectangle of $\\lambda$ and $\\phi_s$, takes the rectangle's edge to the closed curve. Inside, its "
    "Jacobian is not zero, so the image of the inside is open, and bounded by no other points than those of "
    "the curve. Such a set is the whole inside of the curve. It has no holes, so $N_1$, which is one-to-one "
    "near every point, takes each of its values once: a point belongs to one $g/A$ and one $\\gamma$. "
    "Therefore every contour of viscous-controlled backlash lies strictly between those of friction and "
    "inertia. The same holds for $-1/N_1$, as $-1/z$ is continuous with a continuous inverse away from zero."
)
