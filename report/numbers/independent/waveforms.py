"""Sampled and integrated waveforms, and sums of harmonics: second ways to what harmonic balance gives."""

from collections.abc import Mapping

import control
import mpmath
import numpy as np
import sympy

from derivations.elements.waveform import THETA, Segment, Waveform
from trimmer import response_at
from trimmer.elements import Element

DIGITS = 30
PHASES = 2**15
ODD_ORDERS = np.arange(1, 4_002, 2)  # Harmonics of a square wave that are summed
Values = Mapping[sympy.Expr, sympy.Expr]


def integral(segment: Segment, weight: sympy.Expr, values: Values) -> complex:
    """Return the integral of a segment times a weight by quadrature, for numeric values of the symbols."""
    integrand = sympy.lambdify(THETA, (segment.value * weight).subs(values), "mpmath")
    with mpmath.workdps(DIGITS):
        ends = [mpmath.mpf(end.subs(values).evalf(DIGITS)) for end in (segment.start, segment.end)]
        return complex(mpmath.quad(integrand, ends))


def coefficient(waveform: Waveform, weight: sympy.Expr, values: Values) -> complex:
    """Return 1/π times the integral of a waveform times a weight over the period, by quadrature."""
    return sum(integral(segment, weight, values) for segment in waveform.segments) / float(sympy.pi)


def quadrature_gain(waveform: Waveform, amplitude: sympy.Expr, values: Values) -> complex:
    """Return the describing function of a waveform by quadrature, for numeric values of the symbols."""
    sine, cosine = (coefficient(waveform, weight(THETA), values) for weight in (sympy.sin, sympy.cos))
    return (sine + 1j * cosine) / float(amplitude.subs(values))


def sampled_gain(element: Element, amplitude: float, omega: float) -> complex:
    """Return the first harmonic of an element's sampled waveform over the amplitude of its input (rad/s)."""
    phases = 2 * np.pi * np.arange(PHASES) / PHASES
    output = element.waveform(phases, amplitude, omega)
    return complex(2j * np.mean(output * np.exp(-1j * phases)) / amplitude)


def at_the_jump(system: control.TransferFunction, frequency: float, feedback: float) -> float:
    """Return what a square wave of a frequency (Hz) and height π/4 returns with at its upward jump.

    ``feedback`` is a gain round the system.
    """
    response = response_at(system, 2 * np.pi * frequency * ODD_ORDERS)
    return float(np.sum((response / (1 + feedback * response)).imag / ODD_ORDERS))
