"""Claims of section 2.4: backlash and friction as one equivalent nonlinearity (2.57 to 2.60, figure 2.15)."""

import numpy as np
import sympy

from derivations import assumed
from derivations.dimensions import FORCE, LENGTH, TIME, Dimension, dimension_of
from derivations.elements.backlash import friction_waveform
from derivations.elements.friction import FORCE as COULOMB
from derivations.elements.friction import friction_waveform as coulomb_waveform
from derivations.elements.friction import relay_waveform
from derivations.elements.waveform import THETA, describing_function, simplified_describing_function
from derivations.symbols import DIMENSIONS, A, omega
from report.chapters.chapter_2.claims.section_2_3_4_coefficients import BRACKET, printed_sine_terms
from report.chapters.second_ways import by_quadrature
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import CloseNumbers
from report.judging.comparisons.printed import product, total
from report.judging.parts import assertion, close, equal, expression, made_here, part, so
from report.judging.record import Record, claim, text
from report.judging.shown import Words
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.waveforms import quadrature_gain
from trimmer import CoulombFriction, FrictionBacklash
from trimmer.elements import SumOfElements

b = assumed.positive("b")
PLANT, FILTER, BACKLASH, FRICTION = sympy.symbols("G_m G_g N_r N_f")
SAMPLES = 4096
FRICTION_ITEM = "4F_c/(Aπ), Coulomb friction in the equivalent nonlinearity"
COSINE_FORM = r"j\frac{4b}{\pi} \left(\frac{b}{A} - 1\right)"  # The imaginary part of equation 2.59, as TeX
UNITS = DIMENSIONS | {COULOMB: FORCE, b: LENGTH}


def loop() -> sympy.Expr:
    """Return what has to be zero for the velocity v of the plant: friction acts on v, backlash on G_g v."""
    velocity = sympy.Symbol("v")
    drive = -BACKLASH * FILTER * velocity - FRICTION * velocity
    return sympy.expand((velocity - PLANT * drive) / velocity)


@claim("eq-2.57")
def harmonic_balance(_: Evidence) -> Record:
    printed = 1 + (BACKLASH + FRICTION / FILTER) * (PLANT * FILTER)
    form = r"N_{eq}(A, \omega)G_{eq}(j\omega) + 1 = 0"
    yield expression("with equation 2.58 and $G_{eq} = G_mG_g$", printed, loop(), form=form)
    yield text("""
        In the loop of figure 2.15 both nonlinearities act on the plant's input. Collected over $G_{eq} = G_m
        G_g$, it has the printed condition.
    """)


@claim("eq-2.58")
def equivalent(_: Evidence) -> Record:
    derived = sympy.simplify((loop() - 1) / (PLANT * FILTER))
    form = r"N_{eq}(A, \omega) = N_r(A) + \frac{1}{G_g(j\omega)}N_f(A)"
    yield expression("", BACKLASH + FRICTION / FILTER, derived, form=form)
    yield text("""
        The equation is right as block algebra, but its arguments differ. $N_r$ belongs to the amplitude $A$
        of the filtered signal, $N_f$ to the amplitude $A_v = A/|G_g|$ before the filter. The equation writes
        $A$ for both.
    """)


def printed_backlash_part(label: str) -> ClaimPart:
    """Return the part on N_r, whose slip equations 2.59 and 5.14 share."""
    right = rf"\frac{{A}}{{\pi}} \left({BRACKET}\right)"
    wave = friction_waveform(2 * b)
    derived, real = describing_function(wave, A), wave.sine_coefficient() / A
    cosine = 4 * b / sympy.pi * (b / A - 1)
    values = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
    return expression(
        label,
        product(1 / A, total(*printed_sine_terms(), sympy.I * cosine)),
        simplified_describing_function(wave, A),
        assume=sympy.Gt(A, b),
        second=by_quadrature(derived, quadrature_gain(wave, A, values), values),
        slip=made_here("the factor A/π of b₁ is lost", derived - real + real * sympy.pi / A),
        printed_form=rf"N_r(A) = \frac{{1}}{{A}} \left({BRACKET} + {COSINE_FORM}\right)",
        derived_form=rf"N_r(A) = \frac{{1}}{{A}} \left({right} + {COSINE_FORM}\right)",
        item="1/A (π/2 − …) without A/π, friction-controlled backlash in the equivalent nonlinearity",
        severity=Severity.SLIP,
    )


@claim("eq-2.59")
def backlash_part(_: Evidence) -> Record:
    yield printed_backlash_part("")
    yield text(r"""
        The real part is $b_1/A$ with $b_1$ of [equation 2.40](#eq-2.40), whose factor $A/\pi$ is missing. As
        printed it has the unit 1/m, and tends to $\pi/A$ instead of one for large amplitudes.

        No result is affected: equation 5.14 repeats it, but [Listing A.6](#lst-A.6), which draws the
        contours, has the factor.
    """)


@claim("eq-2.60")
def friction_part(_: Evidence) -> Record:
    printed, of_velocity = 4 * COULOMB / (A * sympy.pi), describing_function(relay_waveform(), A)
    integrator = 1 / (sympy.I * omega)
    derived = sympy.simplify(4 * COULOMB / (sympy.pi * A / sympy.Abs(integrator)))
    form = r"N_f(A) = \frac{4F_c}{A\pi}"
    label = "with $A$ read as the amplitude of the velocity"
    yield expression(label, printed, of_velocity, form=form, item=FRICTION_ITEM)
    yield expression(
        "with $A$ read as the amplitude after the integrator",
        printed,
        derived,
        second=equal("its unit, N s/m", dimension_of(derived, UNITS), FORCE * TIME / LENGTH),
        slip=made_here("A is used in place of the amplitude of the velocity", printed),
        printed_form=form,
        derived_form=r"N_f(A) = \frac{4F_c}{\omega A\pi}",
        item=FRICTION_ITEM,
        certainty=Certainty.READING,
    )
    yield text(r"""
        Friction sees the velocity, and if $A$ is its amplitude the equation is right. But equation 2.58 adds
        the function to $N_r(A)$, whose $A$ is the amplitude after the integrator. The velocity then has the
        amplitude $\omega A$, and the describing function is $4F_c/(\pi\omega A)$.

        Equation 5.14 takes the second meaning of $A$ and divides by $j\omega$, where $1/G_g = j\omega$ would
        multiply, see [the Coulomb term](#txt-5.2.5-coulomb-term).
    """)


@claim("txt-2.4-amplitude-relation")
def amplitude_relation(_: Evidence) -> Record:
    velocity, integrator = assumed.positive("A_v"), 1 / (sympy.I * omega)
    integrated = sympy.Abs(velocity * sympy.exp(sympy.I * THETA) * integrator)
    printed = velocity * sympy.Abs(integrator)
    yield expression(
        "for the integrator $G_g = 1/s$",
        printed,
        integrated,
        sympy.Symbol("A"),
        printed_form=r"A = A_v|G_g(j\omega)|",
    )
    yield text("""
        A linear filter multiplies an amplitude by the magnitude of its response. The text calls $G_g$ a
        digital low-pass filter that raises the order of the model. For the trimmer it is the integrator from
        velocity to displacement, and nothing is added to the plant.
    """)


@claim("txt-2.4-units")
def units(_: Evidence) -> Record:
    backlash = describing_function(friction_waveform(2 * b), A)
    friction = 4 * COULOMB / (omega * A * sympy.pi)
    first, second = (dimension_of(term, UNITS) for term in (sympy.re(backlash), friction))
    in_milliseconds = {COULOMB: COULOMB / 10**6, omega: omega / 1000}
    altered = sympy.simplify(friction.subs(in_milliseconds) - friction) != 0
    yield assertion(
        "",
        "the two terms of $N_{eq}$ can be added",
        first == second,
        f"the backlash term is a number, the friction term of equation 5.14 is in {written(second)}",
        method="dimension check of both terms",
        second=so(
            "seconds changed to milliseconds, which leaves the first term and alters the second",
            (altered, backlash.subs(in_milliseconds) == backlash),
        ),
    )
    stiffness = written(dimension_of(4 * COULOMB / (sympy.pi * A), UNITS))
    yield text(rf"""
        The thesis adds the two terms and does not speak of their units. Backlash turns a displacement into a
        displacement, friction a velocity into a force. However $A$ is read in equation 2.60, the friction
        term is no pure number. With the right operator it is a stiffness, $j\,4F_c/(\pi A)$ in {stiffness},
        and has to be divided by one, such as $k_2$, before it can be added to a number.

        Every contour of section 5.2.5 adds quantities of different units, so its numbers have no physical
        meaning.
    """)


def written(dimension: Dimension | None) -> str:
    """Return a unit with its exponents raised."""
    return str(dimension).replace("^-1", "⁻¹").replace("^-2", "⁻²")


@claim("fig-2.15")
def in_parallel(_: Evidence) -> Record:
    plant, integral, backlash, friction = sympy.symbols("G_m G_g N_r N_f")
    # Rows: v = G_m u, x = G_g v, u = -N_r x - N_f v, for the signals (v, x, u).
    apart = sympy.Matrix([[1, 0, -plant], [-integral, 1, 0], [friction, backlash, 1]]).det()
    in_one = product(total(backlash, friction / integral), product(plant, integral))
    printed = total(in_one, sympy.Integer(1))
    yield expression("(a) and (b) have the same condition", printed, sympy.expand(apart))

    values = {A: sympy.Integer(1), COULOMB: sympy.Rational(2, 5)}
    waves = (friction_waveform(sympy.Rational(3, 5)), coulomb_waveform())
    by_quadrature = sum(quadrature_gain(wave, A, values) for wave in waves)
    both = SumOfElements((FrictionBacklash(0.6), CoulombFriction(0.4)))
    together = complex(both.describing_function(1.0))
    # Half a step off, so that no sample meets a jump.
    phases = 2 * np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES
    fundamental = complex(2j * np.mean(both.waveform(phases, 1.0) * np.exp(-1j * phases)))
    means = "the first line in the spectrum of the sum of both waveforms"
    yield part(
        "describing function of backlash and friction in parallel, one example",
        CloseNumbers(together, by_quadrature),
        second=close(means, fundamental, by_quadrature, 1e-5),
        printed_form=Words("the functions of the two add up"),
        derived_form=Words(
            f"the two by quadrature give {by_quadrature:.6f}, the parallel connection {together:.6f}"
        ),
    )

    integrator = 1 / (sympy.I * omega)
    by_velocity = 4 * COULOMB / (sympy.pi * A / sympy.Abs(integrator)) / integrator
    label = "the branch $N_f/G_g$ for $G_g = 1/s$, with $N_f$ at the velocity's amplitude"
    yield expression(label, by_velocity, describing_function(coulomb_waveform(), A))
    yield text("""
        The two diagrams are one loop, and nonlinearities with a common input add, as integrals do. Friction
        gets that input through $1/G_g$, a differentiator where $G_g$ is an integrator, and its $N_f$ needs
        the amplitude $A/|G_g|$. As an example the figure is right. The trimmer is not of this form, since its
        friction acts between cutter and guard.
    """)
