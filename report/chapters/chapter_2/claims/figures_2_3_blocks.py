"""Claims on the block diagrams of sections 2.3 and 2.4, and on friction as a relay.

These are figures 2.5, 2.6, 2.12 and 2.15.
"""

from __future__ import annotations

import control
import numpy as np
import sympy

from derivations.backlash import friction_waveform as backlash_waveform
from derivations.friction import FORCE, friction_waveform
from derivations.symbols import A, omega
from derivations.waveform import THETA, describing_function
from report.claim import Claim, Confirmation, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.quadrature import coefficient
from report.evidence import Evidence
from report.numbers.textbook_loops import relay_loop
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.sum_of_elements import SumOfElements

SOURCE = "report/chapters/chapter_2/claims/figures_2_3_blocks.py"
LINEAR, NONLINEAR = sympy.symbols("G N")
PLANT, FILTER, BACKLASH, FRICTION = sympy.symbols("G_m G_g N_r N_f")
SAMPLES = 4096
SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_loop(), _block(), _friction_as_relay(), _in_parallel())


def _loop() -> Claim:
    # Rows: e = r - y, u = N e, y = G u, for the signals (e, u, y).
    blocks = sympy.Matrix([[1, 0, 1], [-NONLINEAR, 1, 0], [0, -LINEAR, 1]])
    loop, gain = relay_loop(), 0.7
    closed = control.feedback(gain * loop.plant, 1)
    point = 0.3 + 1.1j
    direct = 1 + gain * complex(loop.plant(point))
    through_poles = complex(np.polyval(closed.den[0][0], point) / np.polyval(loop.plant.den[0][0], point))
    return Claim(
        id="fig-2.5",
        parts=(
            Part(
                "what has to be zero for an oscillation without reference",
                SameExpression(total(product(NONLINEAR, LINEAR), sympy.Integer(1)), blocks.det()),
                Confirmation(
                    "the closed loop of python-control with a constant in the place of $N$",
                    CloseNumbers(direct, through_poles),
                ),
            ),
        ),
        explanation=(
            "With $r = 0$ the signals of the loop are the solutions of three homogeneous equations, and "
            "differ from zero only if their determinant $1 + NG$ is zero. The amplitude is that at the input "
            "of $N$. The drawing was not at hand; it is drawn again from the text."
        ),
        source=SOURCE,
    )


def _block() -> Claim:
    cosine, sine = sympy.Symbol("a_1", real=True), sympy.Symbol("b_1", positive=True)
    magnitude, phase = sympy.sqrt(cosine**2 + sine**2), sympy.atan(cosine / sine)
    gain = (sine + sympy.I * cosine) / A
    output = sympy.im(sympy.expand_complex(gain * A * sympy.exp(sympy.I * THETA)))
    element = FrictionBacklash(0.6)
    wave = element.waveform(2 * np.pi * np.arange(SAMPLES) / SAMPLES, 1.0)
    fundamental = complex(np.fft.fft(wave)[1] * 2j / SAMPLES)
    return Claim(
        id="fig-2.6",
        parts=(
            Part(
                "output $M\\sin(\\omega t + \\varphi)$ for the input $A\\sin\\omega t$",
                SameExpression(magnitude * sympy.sin(THETA + phase), output),
                Confirmation(
                    "the first line in the spectrum of a backlash's output",
                    CloseNumbers(fundamental, complex(element.describing_function(1.0)), 1e-6),
                ),
            ),
        ),
        explanation=(
            "The block turns the phasor of its input by $N$ and gives the first harmonic of the element's "
            "output, of the same frequency. The sentence after equation 2.27 speaks once of a shift in "
            "frequency; amplitude and phase are meant."
        ),
        source=SOURCE,
    )


def _friction_as_relay() -> Claim:
    waveform = friction_waveform()
    velocity = COSINE
    switching = {segment.start % (2 * sympy.pi) for segment in waveform.segments}
    zeros = set(sympy.solveset(velocity, THETA, sympy.Interval.Ropen(0, 2 * sympy.pi)))
    phases = np.linspace(0.1, 6.2, 40)
    relay = Relay(1.0).waveform(phases + np.pi / 2, 1.0)
    displaced = CoulombFriction(1.0).waveform(phases, 1.0)
    levels = {segment.value for segment in waveform.segments}
    loop_area = sympy.pi * A * waveform.cosine_coefficient()
    return Claim(
        id="fig-2.12",
        parts=(
            Part(
                "an ideal relay in the velocity",
                Assertion(
                    statement="friction is a relay that switches where the velocity changes its sign",
                    derived=switching == zeros and levels == {FORCE, -FORCE},
                    evidence=(
                        "under $A\\sin\\theta$ the force is $\\pm F_c$ and switches where the velocity is "
                        f"zero, at $\\theta = {', '.join(sympy.latex(each) for each in sorted(switching))}$"
                    ),
                    method="levels and limits of the derived waveform",
                ),
                Confirmation(
                    "a relay with the velocity as its input, sampled over a period",
                    CloseNumbers(float(np.dot(relay, displaced)), float(phases.size)),
                ),
            ),
            Part(
                "the work that it takes in a period is $4F_cA$, as of a force against the motion",
                SameExpression(4 * FORCE * A, loop_area),
            ),
        ),
        explanation=(
            "The force has two levels and follows the sign of the velocity, as the caption says. Over the "
            "displacement the same force is not a relay's step but a rectangle with the area $4F_cA$; that "
            "is why it matters which of the two is called the input."
        ),
        source="derivations/friction.py",
    )


def _in_parallel() -> Claim:
    # Rows: v = G_m u, x = G_g v, u = -N_r x - N_f v, for the signals (v, x, u).
    apart = sympy.Matrix([[1, 0, -PLANT], [-FILTER, 1, 0], [FRICTION, BACKLASH, 1]]).det()
    printed = total(product(total(BACKLASH, FRICTION / FILTER), product(PLANT, FILTER)), sympy.Integer(1))
    integrator = 1 / (sympy.I * omega)
    velocity = A / sympy.Abs(integrator)
    by_velocity = 4 * FORCE / (sympy.pi * velocity) / integrator
    return Claim(
        id="fig-2.15",
        parts=(
            Part("(a) and (b) have the same condition", SameExpression(printed, sympy.expand(apart))),
            _sum_of_waveforms(),
            Part(
                "the branch $N_f/G_g$ for $G_g = 1/s$, with $N_f$ at the velocity's amplitude",
                SameExpression(by_velocity, describing_function(friction_waveform(), A)),
            ),
        ),
        explanation=(
            "The two diagrams are one loop, and nonlinearities with a common input add, as integrals do. "
            "Friction gets that input through $1/G_g$, a differentiator where $G_g$ is the integrator of the "
            "text, and its $N_f$ needs the amplitude $A/|G_g|$. As an example the figure is right; the "
            "trimmer is not of this form, since its friction acts between cutter and guard."
        ),
        source=SOURCE,
    )


def _sum_of_waveforms() -> Part:
    values = {A: sympy.Integer(1), FORCE: sympy.Rational(2, 5)}
    waves = (backlash_waveform(sympy.Rational(3, 5)), friction_waveform())
    by_quadrature = sum(
        coefficient(wave, SINE, values) + 1j * coefficient(wave, COSINE, values) for wave in waves
    )
    both = SumOfElements((FrictionBacklash(0.6), CoulombFriction(0.4)))
    samples = both.waveform(2 * np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES, 1.0)
    turned = np.exp(-1j * np.pi / SAMPLES)
    fundamental = complex(np.fft.fft(samples)[1] * 2j / SAMPLES * turned)
    return Part(
        "describing function of backlash and friction in parallel, one example",
        CloseNumbers(complex(both.describing_function(1.0)), by_quadrature),
        Confirmation(
            "the first line in the spectrum of the sum of both waveforms",
            CloseNumbers(fundamental, by_quadrature, 1e-5),
        ),
    )
