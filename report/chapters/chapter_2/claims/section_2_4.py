"""Claims of section 2.4: backlash and friction as one equivalent nonlinearity (equations 2.57 to 2.60)."""

from __future__ import annotations

import sympy

from derivations.backlash import friction_waveform
from derivations.dimensions import FORCE, LENGTH, NUMBER, TIME, Dimension, dimension_of
from derivations.friction import FORCE as COULOMB
from derivations.friction import relay_waveform
from derivations.symbols import DIMENSIONS, A, omega
from derivations.waveform import THETA, describing_function, simplified_describing_function
from report.chapters.chapter_2.claims.section_2_3_4_friction_integrals import printed_sine_terms
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.quadrature import coefficient, confirm
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

SOURCE = "report/chapters/chapter_2/claims/section_2_4.py"
b = sympy.Symbol("b", positive=True)
PLANT, FILTER, BACKLASH, FRICTION = sympy.symbols("G_m G_g N_r N_f")
REACHED = sympy.Gt(A, b)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _harmonic_balance(),
        _equivalent(),
        _backlash_part(),
        _friction_part(),
        _amplitude_relation(),
        _units(),
    )


def _loop() -> sympy.Expr:
    """Return what has to be zero for the velocity v of the plant: friction acts on v, backlash on G_g v."""
    velocity = sympy.Symbol("v")
    drive = -BACKLASH * FILTER * velocity - FRICTION * velocity
    return sympy.expand((velocity - PLANT * drive) / velocity)


def _harmonic_balance() -> Claim:
    printed = 1 + (BACKLASH + FRICTION / FILTER) * (PLANT * FILTER)
    return Claim(
        id="eq-2.57",
        parts=(Part("$N_{eq}G_{eq} + 1$", SameExpression(printed, _loop())),),
        explanation=(
            "The loop of figure 2.15 has both nonlinearities act on the plant's input. Collected over "
            "$G_{eq} = G_m G_g$ it is the printed condition."
        ),
        source=SOURCE,
    )


def _equivalent() -> Claim:
    derived = sympy.simplify((_loop() - 1) / (PLANT * FILTER))
    return Claim(
        id="eq-2.58",
        parts=(Part("", SameExpression(BACKLASH + FRICTION / FILTER, derived, left=r"N_{eq}")),),
        explanation=(
            "Right as block algebra. The arguments differ: $N_r$ belongs to the amplitude $A$ of the "
            "filtered signal, $N_f$ to the amplitude $A_v = A/|G_g|$ before the filter, while the equation "
            "writes $A$ for both."
        ),
        source=SOURCE,
    )


def printed_backlash_part(label: str) -> Part:
    """Return the part on N_r, whose slip equations 2.59 and 5.14 share."""
    wave = friction_waveform(2 * b)
    derived = describing_function(wave, A)
    cosine = 4 * b / sympy.pi * (b / A - 1)
    printed = product(1 / A, total(*printed_sine_terms(), sympy.I * cosine))
    real = wave.sine_coefficient() / A
    values = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
    sine, cosine_value = (coefficient(wave, weight(THETA), values) for weight in (sympy.sin, sympy.cos))
    slipped = derived - real + real * sympy.pi / A
    return Part(
        label,
        SameExpression(printed, simplified_describing_function(wave, A), left=r"N_r", assume=REACHED),
        confirm(derived, (sine + 1j * cosine_value) / float(values[A]), values),
        Slip("the factor A/pi of b1 is lost", slipped, Verdict.ERRATUM),
    )


def _backlash_part() -> Claim:
    return Claim(
        id="eq-2.59",
        parts=(printed_backlash_part(""),),
        explanation=(
            "The real part is $b_1/A$ with $b_1$ of equation 2.40, whose factor $A/\\pi$ is missing. As "
            "printed the real part has the unit 1/m, and tends to $\\pi/A$ instead of one for large "
            "amplitudes."
        ),
        consequence="Equation 5.14 repeats it. Listing A.6, which draws the contours, has the factor.",
        impact=Impact.LOCAL,
        source="derivations/backlash.py",
    )


def _friction_part() -> Claim:
    integrator = 1 / (sympy.I * omega)
    velocity_amplitude = A / sympy.Abs(integrator)
    derived = sympy.simplify(4 * COULOMB / (sympy.pi * velocity_amplitude))
    return Claim(
        id="eq-2.60",
        parts=(
            Part(
                "as a function of the amplitude of the velocity",
                SameExpression(
                    4 * COULOMB / (A * sympy.pi), describing_function(relay_waveform(), A), left=r"N_f"
                ),
            ),
            Part(
                "as a function of the amplitude $A$ after the integrator",
                SameExpression(4 * COULOMB / (A * sympy.pi), derived, left=r"N_f"),
                Confirmation(
                    "its unit, N s/m",
                    SameExpression(_exponents(derived), _exponents_of(FORCE * TIME / LENGTH)),
                ),
                Slip(
                    "A is used in place of the amplitude of the velocity",
                    4 * COULOMB / (sympy.pi * A),
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            "Friction sees the velocity, whose amplitude is $\\omega A$ when $A$ is the amplitude after the "
            "integrator. So its describing function is $4F_c/(\\pi\\omega A)$. The printed one is right only "
            "if $A$ means the amplitude of the velocity, but then it is not the $A$ of equation 2.59."
        ),
        consequence=(
            "Equation 5.14 divides by $\\omega$ afterwards, where $1/G_g = j\\omega$ would multiply: see the "
            "statement on the Coulomb term in section 5.2.5."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _units_of_symbols() -> dict[sympy.Expr, Dimension]:
    return DIMENSIONS | {COULOMB: FORCE, b: LENGTH}


def _exponents(expression: sympy.Expr) -> sympy.Expr:
    return _exponents_of(dimension_of(expression, _units_of_symbols()) or NUMBER)


def _exponents_of(dimension: Dimension) -> sympy.Expr:
    kilogram, metre, second = sympy.symbols("kg m s", positive=True)
    return kilogram**dimension.mass * metre**dimension.length * second**dimension.time


def _amplitude_relation() -> Claim:
    velocity = sympy.Symbol("A_v", positive=True)
    turning = velocity * sympy.exp(sympy.I * THETA)
    integrated = sympy.Abs(turning / (sympy.I * omega))
    return Claim(
        id="txt-2.4-amplitude-relation",
        parts=(
            Part(
                "for the integrator $G_g = 1/s$",
                SameExpression(
                    velocity * sympy.Abs(1 / (sympy.I * omega)), integrated, left=sympy.Symbol("A")
                ),
            ),
        ),
        explanation=(
            "A linear filter multiplies an amplitude by the magnitude of its response. The text calls $G_g$ "
            "a digital low-pass filter that raises the order of the model; for the trimmer it is the "
            "integrator from velocity to displacement, and nothing is added to the plant."
        ),
        source=SOURCE,
    )


def _units() -> Claim:
    backlash = describing_function(friction_waveform(2 * b), A)
    friction = 4 * COULOMB / (omega * A * sympy.pi)
    first, second = (dimension_of(term, _units_of_symbols()) for term in (sympy.re(backlash), friction))
    in_milliseconds = {COULOMB: COULOMB / 10**6, omega: omega / 1000}
    stiffness = dimension_of(4 * COULOMB / (sympy.pi * A), _units_of_symbols())
    return Claim(
        id="txt-2.4-units",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the two terms of $N_{eq}$ can be added",
                    derived=first == second,
                    evidence=f"the backlash term is a number, the friction term as used is in {second}",
                    method="dimension check of both terms",
                ),
                second_way(
                    "seconds changed to milliseconds, which leaves the first term and alters the second",
                    backlash.subs(in_milliseconds) == backlash
                    and sympy.simplify(friction.subs(in_milliseconds) - friction) != 0,
                ),
            ),
        ),
        explanation=(
            "Backlash turns a displacement into a displacement, friction a velocity into a force. Even with "
            f"the right operator friction is a stiffness ($j\\,4F_c/(\\pi A)$, in {stiffness}), and needs to "
            "be divided by one, such as $k_2$, before it can be added to a number. Besides, it acts between "
            "cutter and guard, not at the pin, so no sum of the two at one place describes the trimmer."
        ),
        consequence=(
            "Every contour of section 5.2.5 adds quantities of different units; its numbers have no physical "
            "meaning."
        ),
        impact=Impact.DOWNSTREAM,
        source="derivations/dimensions.py",
    )
