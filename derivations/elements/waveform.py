"""A periodic output given by segments of one period, its Fourier coefficients and its describing function."""

from dataclasses import dataclass
from functools import cache

import sympy

from derivations import assumed

THETA = assumed.real("theta")  # Phase of the input A sin θ, rad


@dataclass(frozen=True)
class Segment:
    """The output between two phases."""

    start: sympy.Expr  # First phase, rad
    end: sympy.Expr  # Last phase, rad
    value: sympy.Expr  # The output as an expression in ``THETA``, in its own unit

    def position(self, phase: sympy.Expr) -> sympy.Expr:
        """Return the output at a phase, rad."""
        return self.value.subs(THETA, phase)


@dataclass(frozen=True)
class Waveform:
    """A periodic output."""

    segments: tuple[Segment, ...]  # Follow one another over a whole period of 2π

    def jumps(self) -> tuple[sympy.Expr, ...]:
        """Return by how much the output jumps where one segment ends and the next begins, simplified."""
        following = (*self.segments[1:], self.segments[0])
        return tuple(
            sympy.simplify(after.value.subs(THETA, after.start) - before.value.subs(THETA, before.end))
            for before, after in zip(self.segments, following, strict=True)
        )

    def cosine_coefficient(self, harmonic: int = 1) -> sympy.Expr:
        """Return a_n = (1/π) ∫ y cos nθ dθ over the period (thesis, equation 2.29)."""
        return self._coefficient(sympy.cos(harmonic * THETA))

    def sine_coefficient(self, harmonic: int = 1) -> sympy.Expr:
        """Return b_n = (1/π) ∫ y sin nθ dθ over the period (thesis, equation 2.29)."""
        return self._coefficient(sympy.sin(harmonic * THETA))

    def _coefficient(self, weight: sympy.Expr) -> sympy.Expr:
        return sympy.Add(*(segment_integral(segment, weight) for segment in self.segments)) / sympy.pi


@cache
def segment_integral(segment: Segment, weight: sympy.Expr) -> sympy.Expr:
    """Return the integral over a segment of its output times a weight, by SymPy's own antiderivative."""
    primitive = sympy.integrate(sympy.expand(segment.value * weight), THETA)
    return primitive.subs(THETA, segment.end) - primitive.subs(THETA, segment.start)


@cache
def describing_function(waveform: Waveform, amplitude: sympy.Expr, harmonic: int = 1) -> sympy.Expr:
    """Return N_n = (b_n + j a_n) / A (thesis, equation 2.35, for harmonic n).

    Args:
        waveform: The output.
        amplitude: A of the input A sin θ, in the unit of the input.
        harmonic: n, a number.

    Returns:
        N_n in the unit of output over input.
    """
    cosine, sine = waveform.cosine_coefficient(harmonic), waveform.sine_coefficient(harmonic)
    return (sine + sympy.I * cosine) / amplitude


@cache
def simplified_describing_function(
    waveform: Waveform, amplitude: sympy.Expr, gap: tuple[sympy.Expr, sympy.Expr] | None = None
) -> sympy.Expr:
    """Return N_1 = (b_1 + j a_1) / A with real and imaginary part each simplified by itself.

    Args:
        waveform: The output.
        amplitude: A of the input A sin θ, in the unit of the input.
        gap: A symbol and its replacement, such as the gap in terms of a contact angle.

    Returns:
        N_1 in the unit of output over input.
    """
    sine, cosine = waveform.sine_coefficient(), waveform.cosine_coefficient()
    if gap is not None:
        sine, cosine = sine.subs(*gap), cosine.subs(*gap)
    real, imaginary = (sympy.simplify(coefficient / amplitude) for coefficient in (sine, cosine))
    return sympy.Add(real, sympy.Mul(sympy.I, imaginary, evaluate=False), evaluate=False)
