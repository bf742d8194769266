"""Elements whose describing function is evaluated, and of which no bounds are known."""

from abc import abstractmethod
from collections.abc import Sequence

import numpy as np

from trimmer.arguments import whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.quadrature import QuadratureEstimate, harmonic_by_quadrature
from trimmer.errors import UnsupportedElementError

EVEN = 1e-6
"""Sum of the outputs half a period apart, over the largest output, from which on an element is not odd."""
_STEP = 1e-5  # Relative step of the difference quotients: errors of N of 1e-13 give those of 1e-8


class UnboundedElement(Element):
    """An element that is known by its output over one period only.

    Its harmonics are integrated, its derivatives are difference quotients, and its bounds are infinite:
    harmonic balance searches a grid, and says that nothing is proven.
    """

    has_bounds = False

    @abstractmethod
    def _period(self, phases: Reals, amplitude: float, omega: float) -> Reals:
        """Return the steady output at phases of one amplitude and omega."""

    def _halves(self, phases: Reals, amplitude: float, omega: float) -> tuple[Reals, Reals]:
        """Return the outputs at phases, and half a period later."""
        outputs = self._period(np.concatenate([phases, phases + np.pi]), amplitude, omega)
        return outputs[: phases.size], outputs[phases.size :]

    def _breaks(self, amplitude: float, omega: float) -> Sequence[float]:
        """Return the phases, rad, at which the output has a kink or a jump, as far as they are known."""
        return ()

    def describing_function_estimate(
        self, amplitude: float, omega: float | None = None, harmonic: int = 1
    ) -> QuadratureEstimate:
        """Integrate N_n at one amplitude, and estimate the error.

        Args:
            amplitude: A > 0, finite, in the unit of the input.
            omega: Angular frequency, rad/s, > 0. Needed if ``depends_on_frequency``.
            harmonic: n >= 1.

        Returns:
            Value and estimate of the error, both NaN where there is no steady output.

        Raises:
            ValueError: as for ``describing_function``, and for an array.
            UnsupportedElementError: if the element is not odd at this amplitude.
        """
        number = whole_number("harmonic", harmonic, 1)
        amplitudes, omegas = self._inputs(amplitude, omega)
        if amplitudes.ndim or omegas.ndim or not np.isfinite(amplitudes):
            raise ValueError(
                f"amplitude and omega must be one finite number each, not {amplitude!r} and {omega!r}"
            )
        estimate = self._estimate(float(amplitudes), float(omegas), number if number % 2 else 1)
        return estimate if number % 2 or np.isnan(estimate.value) else estimate._replace(value=0j)

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return infinity: no bound is known."""
        return np.inf, np.inf

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return infinity: no bound is known."""
        return np.inf, np.inf

    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        """Return NaN: how the mean of the input passes is not known."""
        return np.nan

    def _mean_slope(self, amplitude: Reals) -> Reals:
        """Return N - (u/2) dN/du, which is the mean slope over a period of a function f without memory.

        By parts, N = (1/π) ∫ f' cos² θ dθ and A dN/dA = (1/π) ∫ f' dθ - 2 N.
        """
        value, by_u, _ = self._expansion(amplitude, np.ones_like(amplitude))
        return np.asarray(value.real - 0.5 * self.amplitude_scale / amplitude * by_u.real)

    def _estimate(self, amplitude: float, omega: float, harmonic: int) -> QuadratureEstimate:
        estimate = harmonic_by_quadrature(
            lambda phases: self._halves(phases, amplitude, omega),
            amplitude,
            harmonic,
            self._breaks(amplitude, omega),
        )
        if estimate.odd > EVEN:
            raise UnsupportedElementError(
                f"{self!r} is not odd at the amplitude {amplitude:.6g}: outputs half a period apart must "
                "have opposite signs and the same size"
            )
        return estimate

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        values = np.full(amplitude.shape, np.nan, dtype=complex)
        finite = np.isfinite(amplitude) & ~np.isnan(omega)
        for place in np.flatnonzero(finite):
            values[place] = self._estimate(float(amplitude[place]), float(omega[place]), harmonic).value
        return values

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        values = np.full(phase.shape, np.nan)
        known = ~(np.isnan(phase) | np.isnan(amplitude) | np.isnan(omega))
        points = np.stack([amplitude, omega])
        for pair in np.unique(points[:, known], axis=1).T:
            which = known & (points == pair[:, None]).all(axis=0)
            values[which] = self._period(phase[which], float(pair[0]), float(pair[1]))
        return values

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = self._describing_function(amplitude, omega, 1)
        by_log_amplitude = self._quotient(value, amplitude, omega, (1.0, 0.0))
        by_log_omega = np.zeros_like(value)
        if self.depends_on_frequency:
            by_log_omega = self._quotient(value, amplitude, omega, (0.0, 1.0))
        return Expansion(value, -by_log_amplitude * amplitude / self.amplitude_scale, by_log_omega)

    def _quotient(
        self, value: Complexes, amplitude: Reals, omega: Reals, direction: tuple[float, float]
    ) -> Complexes:
        """Return a derivative by ln A or ln omega; one-sided where N exists on one side only."""
        up, down = (
            self._describing_function(
                amplitude * np.exp(step * direction[0]), omega * np.exp(step * direction[1]), 1
            )
            for step in (_STEP, -_STEP)
        )
        central = (up - down) / (2.0 * _STEP)
        one_sided = np.where(np.isnan(up), (value - down) / _STEP, (up - value) / _STEP)
        return np.asarray(np.where(np.isnan(central), one_sided, central))
