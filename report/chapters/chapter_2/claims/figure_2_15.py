"""Claim on figure 2.15: backlash and friction in parallel, as two diagrams of one loop."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.elements.backlash import friction_waveform as backlash_waveform
from derivations.elements.friction import FORCE, friction_waveform
from derivations.elements.waveform import describing_function
from derivations.symbols import A, omega
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import product, total
from report.evidence import Evidence
from report.numbers.independent.waveforms import quadrature_gain
from report.parts import close, expression, part
from report.record import Record, claim, text
from trimmer import CoulombFriction, FrictionBacklash, SumOfElements

SAMPLES = 4096


@claim("fig-2.15", source="report/chapters/chapter_2/claims/figure_2_15.py")
def in_parallel(_: Evidence) -> Record:
    plant, integral, backlash, friction = sympy.symbols("G_m G_g N_r N_f")
    # Rows: v = G_m u, x = G_g v, u = -N_r x - N_f v, for the signals (v, x, u).
    apart = sympy.Matrix([[1, 0, -plant], [-integral, 1, 0], [friction, backlash, 1]]).det()
    in_one = product(total(backlash, friction / integral), product(plant, integral))
    printed = total(in_one, sympy.Integer(1))
    yield expression("(a) and (b) have the same condition", printed, sympy.expand(apart))

    values = {A: sympy.Integer(1), FORCE: sympy.Rational(2, 5)}
    waves = (backlash_waveform(sympy.Rational(3, 5)), friction_waveform())
    by_quadrature = sum(quadrature_gain(wave, A, values) for wave in waves)
    both = SumOfElements((FrictionBacklash(0.6), CoulombFriction(0.4)))
    # Half a step off, so that no sample meets a jump.
    phases = 2 * np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES
    fundamental = complex(2j * np.mean(both.waveform(phases, 1.0) * np.exp(-1j * phases)))
    means = "the first line in the spectrum of the sum of both waveforms"
    yield part(
        "describing function of backlash and friction in parallel, one example",
        CloseNumbers(complex(both.describing_function(1.0)), by_quadrature),
        second=close(means, fundamental, by_quadrature, 1e-5),
    )

    integrator = 1 / (sympy.I * omega)
    by_velocity = 4 * FORCE / (sympy.pi * A / sympy.Abs(integrator)) / integrator
    label = "the branch $N_f/G_g$ for $G_g = 1/s$, with $N_f$ at the velocity's amplitude"
    yield expression(label, by_velocity, describing_function(friction_waveform(), A))
    yield text("""
        The two diagrams are one loop, and nonlinearities with a common input add, as integrals do. Friction
        gets that input through $1/G_g$, a differentiator where $G_g$ is the integrator of the text, and its
        $N_f$ needs the amplitude $A/|G_g|$. As an example the figure is right; the trimmer is not of this
        form, since its friction acts between cutter and guard.
    """)
