"""Claims of section 2.3.3 and figure 2.6: the describing function and its Fourier coefficients."""

import sympy

from derivations import assumed
from derivations.elements.backlash import GAMMA, separation_angle
from derivations.elements.waveform import THETA, Segment, Waveform
from derivations.symbols import A, omega, t
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.printed import total
from report.judging.parts import assertion, close, expression, made_here, same
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.waveforms import sampled_gain
from report.numbers.thesis import DRIVE_OMEGA
from trimmer import FrictionBacklash, ViscousBacklash

COSINE_PART, SINE_PART = assumed.real("a_1"), assumed.positive("b_1")
MODULUS, ANGLE = sympy.sqrt(COSINE_PART**2 + SINE_PART**2), sympy.atan(COSINE_PART / SINE_PART)
"""Magnitude and phase of the first harmonic, equations 2.32 and 2.33."""
MEAN, COSINES, SINES = sympy.Symbol("a_0"), sympy.symbols("a_1:3"), sympy.symbols("b_1:3")
HARMONICS = [
    a * sympy.cos(n * THETA) + b * sympy.sin(n * THETA)
    for n, a, b in zip((1, 2), COSINES, SINES, strict=True)
]
SERIES = total(MEAN / 2, *HARMONICS)
WAVE = Waveform((Segment(-sympy.pi, sympy.pi, SERIES),))  # A signal of two harmonics


@claim("txt-2.3.3-amplitude-only")
def amplitude_only(_: Evidence) -> Record:
    near_limit_cycle, load, amplitude = 4609.5, 1e-3, 2.0
    element, separation = ViscousBacklash(1.0, load), separation_angle()
    driven, cycling = (
        complex(element.describing_function(amplitude, each)) for each in (DRIVE_OMEGA, near_limit_cycle)
    )
    statement = "the describing functions of backlash and of Coulomb friction depend on the amplitude alone"
    independent = Assertion(
        statement=statement,
        derived=GAMMA not in separation.free_symbols,
        asserted=False,
        evidence=f"the bridge separates at ${sympy.latex(separation)}$",
        method=r"it contains $\gamma = M\omega/D$",
    )
    yield assertion(
        "",
        statement,
        abs(driven - cycling) < 1e-9,
        f"""
        at an amplitude of {amplitude:.0f} gaps a load with $M/D$ of {1e3 * load:.0f} ms has $N =
        {driven.real:.3f} {driven.imag:+.3f}j$ at {DRIVE_OMEGA:.0f} rad/s and ${cycling.real:.3f}
        {cycling.imag:+.3f}j$ at {near_limit_cycle:.0f} rad/s
        """,
        method="the describing function of viscous-controlled backlash at two frequencies",
        second=Confirmation("the derived phase of separation", independent),
    )
    yield text(r"""
        This is true of friction-controlled and inertia-controlled backlash and of a relay.
        Viscous-controlled backlash, the general case, depends on $\gamma = M\omega/D$ too, as section 2.3.4
        itself says.

        None: sections 2.3.4 and 2.3.6 put it right. For a load with inertia and friction
        [equation 2.55](#eq-2.55) is to be used and not 2.56.
    """)


@claim("fig-2.6")
def describing_function_block(_: Evidence) -> Record:
    factor = (SINE_PART + sympy.I * COSINE_PART) / A
    output = sympy.im(sympy.expand_complex(factor * A * sympy.exp(sympy.I * THETA)))
    element = FrictionBacklash(0.6)
    sampled, formula = sampled_gain(element, 1.0, 1.0), complex(element.describing_function(1.0))
    yield expression(
        r"output $M\sin(\omega t + \varphi)$ for the input $A\sin\omega t$",
        MODULUS * sympy.sin(THETA + ANGLE),
        output,
        second=close("the first line in the spectrum of a backlash's output", sampled, formula, 1e-6),
    )
    yield text("""
        The block multiplies the phasor of its input by $N$ and gives the first harmonic of the element's
        output. Its frequency is that of the input. The sentence after equation 2.27 speaks once of a shift in
        frequency; amplitude and phase are meant.
    """)


def sinusoid_part() -> ClaimPart:
    """Return the part on the sine written as an exponential, which two claims share."""
    exponential, sine = A * sympy.exp(sympy.I * omega * t), A * sympy.sin(omega * t)
    return expression(
        "",
        exponential,
        sine,
        second=same("Euler's formula", sympy.im(exponential), sine),
        slip=made_here("the imaginary part is not taken", exponential),
        item="A sin(ωt) = A e^(jωt), sinusoidal input of the nonlinearity",
        printed_form=r"u(t) = A\sin(\omega t) = Ae^{j\omega t}",
        derived_form=r"u(t) = A\sin(\omega t) = \operatorname{Im} Ae^{j\omega t}",
    )


@claim("eq-2.27")
def sinusoid(_: Evidence) -> Record:
    yield sinusoid_part()
    yield text(r"""
        Read as an equation it is wrong: a real sine is the imaginary part of the exponential, $A\sin\omega t
        = \operatorname{Im} Ae^{j\omega t}$. Read as a phasor that stands for the sine, which is surely
        meant, it is the usual notation.

        None: the ratio of phasors in equation 2.35 is right.
    """)


@claim("txt-2.3.3-df-definition")
def definition(_: Evidence) -> Record:
    yield sinusoid_part()
    yield text("""
        As at [equation 2.27](#eq-2.27): wrong as an equation, usual as a notation for phasors.

        None: the ratio of phasors in equation 2.35 is right.
    """)


@claim("eq-2.28")
def fourier_series(_: Evidence) -> Record:
    harmonics = (
        WAVE.cosine_coefficient(n) * sympy.cos(n * THETA) + WAVE.sine_coefficient(n) * sympy.sin(n * THETA)
        for n in (1, 2)
    )
    rebuilt = WAVE.cosine_coefficient(0) / 2 + sympy.Add(*harmonics)
    form = r"y(t) = \frac{a_0}{2} + \sum_{n=1}^\infty (a_n \cos(n\omega t) + b_n \sin(n\omega t))"
    yield expression("up to $n = 2$", SERIES, sympy.expand(rebuilt), form=form)
    yield text("""
        A signal of two harmonics is rebuilt from its coefficients by the printed series, with half of $a_0$.
    """)


@claim("eq-2.29")
def fourier_coefficients(_: Evidence) -> Record:
    mean = sympy.expand(WAVE.cosine_coefficient(0))
    yield expression("$a_0$", mean, MEAN, form=integral_form("a_0", ""))
    for n, symbol in enumerate(COSINES, start=1):
        form, derived = integral_form("a_n", r" \cos(n\omega t)"), sympy.expand(WAVE.cosine_coefficient(n))
        yield expression(
            f"$a_n$ for $n = {n}$", derived, symbol, form=form, item="integral for a_n, Fourier coefficients"
        )
    for n, symbol in enumerate(SINES, start=1):
        form, derived = integral_form("b_n", r" \sin(n\omega t)"), sympy.expand(WAVE.sine_coefficient(n))
        yield expression(
            f"$b_n$ for $n = {n}$", derived, symbol, form=form, item="integral for b_n, Fourier coefficients"
        )
    yield text("The printed integrals, over a signal of two harmonics, give back each of its coefficients.")


def integral_form(name: str, weight: str) -> str:
    """Return TeX of an integral of Fourier as printed: what it gives, and the weight of y."""
    return rf"{name} = \frac{{1}}{{\pi}} \int_{{-\pi}}^{{\pi}} y(t){weight} \,d(\omega t)"


@claim("eq-2.30")
def fundamental_coefficients(_: Evidence) -> Record:
    cosine, sine = (sympy.expand(each) for each in (WAVE.cosine_coefficient(), WAVE.sine_coefficient()))
    yield expression("$a_1$", cosine, COSINES[0], form=integral_form("a_1", r" \cos(\omega t)"))
    yield expression("$b_1$", sine, SINES[0], form=integral_form("b_1", r" \sin(\omega t)"))
    yield text("These are the integrals of [equation 2.29](#eq-2.29) for $n = 1$.")


@claim("eq-2.31")
def first_harmonic(_: Evidence) -> Record:
    printed = total(COSINE_PART * sympy.cos(THETA), SINE_PART * sympy.sin(THETA))
    shifted = sympy.simplify(sympy.expand_trig(MODULUS * sympy.sin(THETA + ANGLE)))
    form = r"y(t) \approx a_1\cos(\omega t) + b_1\sin(\omega t) = M\sin(\omega t + \phi)"
    yield expression(r"with $M$ and $\phi$ of equations 2.32 and 2.33", printed, shifted, form=form)
    yield text("The sum of cosine and sine is one sine with the printed magnitude and phase, for $b_1 > 0$.")


@claim("eq-2.32")
def magnitude(_: Evidence) -> Record:
    yield expression("", MODULUS, sympy.Abs(SINE_PART + sympy.I * COSINE_PART), "M")
    yield text("It is the magnitude of $b_1 + ja_1$.")


@claim("eq-2.33")
def phase(_: Evidence) -> Record:
    yield expression("for $b_1 > 0$", ANGLE, sympy.atan2(COSINE_PART, SINE_PART), r"\phi")
    yield text("""
        It is the angle of $b_1 + ja_1$ as long as $b_1 > 0$, as for every backlash. The arctangent of a ratio
        loses the quadrant: for $b_1 < 0$ it is off by half a turn. Coulomb friction driven by a displacement
        has $b_1 = 0$.
    """)


@claim("eq-2.34")
def ratio_of_signals(_: Evidence) -> Record:
    modulus, angle = assumed.positive("M phi")
    printed = modulus * sympy.sin(omega * t + angle) / (A * sympy.sin(omega * t))
    derived = modulus / A * sympy.exp(sympy.I * angle)
    phasors = modulus * sympy.exp(sympy.I * (omega * t + angle)) / (A * sympy.exp(sympy.I * omega * t))
    values = {modulus: 1, A: 1, angle: sympy.pi / 3, omega: 1}
    instants = (sympy.Rational(1, 2), sympy.Integer(1))
    early, late = (float(printed.subs(values).subs(t, instant)) for instant in instants)
    yield expression(
        "",
        printed,
        derived,
        "N",
        second=same("the ratio of the phasors", sympy.simplify(phasors), derived),
        slip=made_here("the ratio of the signals is taken, not that of their phasors", printed),
        printed_form=r"N(A, \omega) = \frac{y(t)}{u(t)} = \frac{M\sin(\omega t + \phi)}{A\sin(\omega t)}",
        derived_form=r"N(A, \omega) = \frac{M}{A} e^{j\phi}",
    )
    yield text(rf"""
        Read as it stands, the ratio of two sines depends on time: for $\phi = {sympy.latex(values[angle])}$
        it is {early:.2f} at $\omega t = {sympy.latex(instants[0])}$ and {late:.2f} at $\omega t =
        {sympy.latex(instants[1])}$. The describing function is the ratio of the phasors, a complex constant.
        Read as phasors, as the next line of the thesis does, the equation is right.

        None: [equation 2.35](#eq-2.35) takes the ratio of the phasors.
    """)


@claim("eq-2.35")
def describing_function(_: Evidence) -> Record:
    printed = (SINE_PART + sympy.I * COSINE_PART) / A
    derived = MODULUS / A * sympy.exp(sympy.I * ANGLE)
    point = {A: 2, COSINE_PART: -0.7, SINE_PART: 1.3}
    second = close("numbers", complex(printed.subs(point)), complex(derived.subs(point)))
    ratio = r"\frac{Me^{j(\omega t + \phi)}}{Ae^{j\omega t}}"
    form = rf"N(A, \omega) = {ratio} = \frac{{M}}{{A}} e^{{j\phi}} = \frac{{1}}{{A}} (b_1 + ja_1)"
    yield expression("", printed, sympy.simplify(sympy.expand_complex(derived)), second=second, form=form)
    yield text("""
        It is the output's phasor over the input's, where $a$ goes with the cosine and $b$ with the sine.
    """)
