"""Claims of section 5.2.1 on the describing function: domain, loci, input, library (equations 5.4 to 5.6)."""

import math

import control
import sympy

from derivations import assumed
from derivations.elements.backlash import GAP, friction_waveform
from derivations.elements.waveform import describing_function
from derivations.symbols import A
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, expression, made_here
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.symbolic import least_amplitude_with_contact
from report.numbers.independent.waveforms import quadrature_gain
from trimmer import FrictionBacklash

OURS = FrictionBacklash(1.0)
LIBRARY = control.friction_backlash_nonlinearity(1.0)


@claim("eq-5.4")
def domain(known: Evidence) -> Record:
    edge = 1.0 / float(OURS.domain(1.0))
    second = close("the contact angle exists", least_amplitude_with_contact(), edge)
    slip = made_here("b is taken for half of the gap, as in section 2.3.4", 2 * edge)
    yield digits("edge of the domain over the gap $b$ of this section", "1.0", edge, second=second, slip=slip)
    yield text(rf"""
        With $b$ as half of the gap, as in section 2.3.4, the condition is right. With $b$ as the whole gap,
        as footnote 8 has it and the listings and tables of this section use it, the pin reaches the bridge as
        soon as $A > b/2$. Table 5.1 itself has a limit cycle at $A =
        {known.cycles.friction.unstable.amplitude:.3f}\,b$, where the equation has no describing function.

        No number of the thesis follows from it. Whoever takes the condition from here loses the second limit
        cycle.
    """)


@claim("eq-5.5")
def proportionality(_: Evidence) -> Record:
    function = describing_function(friction_waveform(), A)
    at_one, at_ten = (complex((function * A / GAP).subs({GAP: 1, A: ratio})) for ratio in (1, 10))
    by_library = 10 * LIBRARY.describing_function(10.0)
    limit = sympy.limit(function.subs(GAP, 1), A, sympy.oo)
    yield assertion(
        "",
        "$N$ is proportional to $b/A$, so $-1/N$ is proportional to $-A/b$",
        abs(at_one - at_ten) < 1e-9,
        rf"""
        $NA/b$ is {abs(at_one):.2f} in size at $A = b$ and {abs(at_ten):.2f} at $A = 10b$; for large
        amplitudes $N \to {sympy.latex(limit)}$
        """,
        method="the derived describing function at two amplitudes, and its limit",
        second=close("python-control's describing function at $A = 10b$", by_library, at_ten),
    )
    yield text("""
        $N$ is a function of $b/A$, but not a multiple of it: where $b/A$ tends to zero, $N$ tends to one. The
        printed proportion is that of a relay. The text takes from it that $-1/N$ grows with the gap. That is
        so at a given amplitude, but the printed $-A/b$ shrinks with the gap.

        The text concludes that a larger gap moves the curve until it meets $G$ a second time. The curve as a
        whole does not depend on the gap; only the amplitudes along it do.
    """)


@claim("eq-5.6")
def external_input(_: Evidence) -> Record:
    time, amplitude = assumed.real("t"), sympy.Rational("0.0015")
    printed = amplitude * sympy.sin(200 * sympy.pi * time)
    derived = sympy.im(amplitude * sympy.exp(2 * sympy.pi * 100 * sympy.I * time))
    form = r"r(t) = 0.0015\sin(2\pi 100t)"
    yield expression("", printed, derived, left=sympy.Symbol("r"), printed_form=form)
    yield text("""
        This is [equation 2.1](#eq-2.1) with an eccentricity of 1.5 mm and 100 turns a second. The motor of
        the experiment turned faster; see [where its frequency is quoted](#txt-3.2-drive-frequency).
    """)


@claim("txt-5.2.1-locus-directions")
def locus_directions(_: Evidence) -> Record:
    amplitudes = 1e6, 0.5 * (1 + 1e-2), 0.5 * (1 + 1e-4)
    far, near, nearer = (complex(-1 / OURS.describing_function(each)) for each in amplitudes)
    far_by_library, _, nearer_by_library = (-1 / LIBRARY.describing_function(each) for each in amplitudes)
    means = "python-control's describing function there"
    distance = abs(far + 1)
    yield assertion(
        "with growing amplitude",
        "$-1/N$ tends to $-1$",
        distance < 1e-4,
        f"at $A = 10^6 b$ it is $-1$ to {power_of(distance)}",
        method="the describing function at large amplitude",
        second=close(means, far_by_library, far, 1e-6),
    )
    yield assertion(
        "with growing gap at fixed amplitude",
        r"$-1/N$ tends to $(-\infty, -\infty j)$",
        (nearer.real < near.real < 0, nearer.imag < near.imag < 0),
        f"""
        it runs from {near.real:.0f} {near.imag:+.0f} j to {nearer.real:.0f} {nearer.imag:+.0f} j as the gap
        comes from 1 % to 0.01 % below twice the amplitude
        """,
        method="the describing function near the edge of the dead band",
        second=close(means, nearer_by_library, nearer, 1e-6),
    )
    yield text("""
        Both directions are right. They are one motion along one curve, whose parameter is $b/A$.
    """)


@claim("txt-5.2.1-second-implementation")
def library(_: Evidence) -> Record:
    distance = max(
        abs(complex(OURS.describing_function(a)) - LIBRARY.describing_function(a))
        for a in (0.51, 0.7, 1.0, 4.0, 90.0)
    )
    values = {A: sympy.Integer(4), GAP: sympy.Integer(1)}
    quadrature, theirs = quadrature_gain(friction_waveform(), A, values), LIBRARY.describing_function(4.0)
    yield assertion(
        "agreement",
        "the library's describing function of backlash agrees with the listing's",
        distance < 1e-12,
        f"they differ by {power_of(distance)} at most, at five amplitudes from 0.51 to 90 gaps",
        method="python-control evaluated beside ours",
        second=close("quadrature of the waveform at four gaps", quadrature, theirs),
    )
    named = ("friction_backlash", "relay_hysteresis", "saturation")
    names = [f"`{name}_nonlinearity`" for name in named if hasattr(control, f"{name}_nonlinearity")]
    saturated = control.saturation_nonlinearity(1.0).describing_function(2.0)
    by_hand = 2 / math.pi * (math.asin(0.5) + 0.5 * math.sqrt(0.75))
    yield assertion(
        "what the library holds",
        "it holds no other describing function",
        len(names) == 1,
        f"it has {', '.join(names)}",
        method="names in the installed python-control",
        second=close("that of saturation, called for twice its bound", saturated, by_hand),
        certainty=Certainty.READING,
    )
    yield text("""
        The two implementations agree, with the total gap as parameter in both. If the text means that of its
        own elements only friction-controlled backlash is in the library, that is nearly so: the library's
        relay, taken without hysteresis, is the text's Coulomb friction. If it means the library as a whole,
        there are three.

        The function for Coulomb friction could have been checked against the library too.
    """)
