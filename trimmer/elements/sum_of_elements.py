"""A sum of elements that share one input."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.arguments import require_instances
from trimmer.elements.bounds import range_shape
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Element
from trimmer.elements.expansion import Expansion, GainSensitivity, GainVariation

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Range


@final
@dataclass(frozen=True)
class SumOfElements(Element):
    """Elements with the same input whose outputs add; their describing functions of each harmonic add too.

    Attributes:
        terms: The elements, at least one; all outputs in the same unit.

    Raises:
        ValueError: if there is no term.
    """

    terms: tuple[Element, ...]

    def __post_init__(self) -> None:
        terms = require_instances("terms", self.terms, object, "an element")
        adopted_terms = tuple(adopted(f"terms[{place}]", term) for place, term in enumerate(terms))
        object.__setattr__(self, "terms", adopted_terms)
        if not self.terms:
            raise ValueError("terms must hold at least one element")

    @property
    def depends_on_frequency(self) -> bool:
        """Whether any term depends on frequency."""
        return any(term.depends_on_frequency for term in self.terms)

    @property
    def amplitude_scale(self) -> float:
        """The scale of the first term; u of the sum is that of this term."""
        return self.terms[0].amplitude_scale

    @property
    def has_bounds(self) -> bool:
        """Whether all terms have bounds."""
        return all(term.has_bounds for term in self.terms)

    @property
    def constant_from(self) -> float:
        """The largest of the terms' values, each in terms of the u of the sum."""
        return max(self._ratio(term) * term.constant_from for term in self.terms)

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return the smallest of the terms' suprema, each in terms of the u of the sum."""
        omegas = self._omegas(omega)
        limits = [self._ratio(term) * term.domain(omegas) for term in self.terms]
        return np.asarray(reduce(np.minimum, limits))[()]

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Return the sums of the terms' bounds: a modulus of a sum is at most the sum of the moduli."""
        bounds = [
            (self._ratio(term), term.sensitivity(self._range_of(term, u_range), omega_range))
            for term in self.terms
        ]
        return GainSensitivity(
            reduce(add, (bound.by_u / ratio for ratio, bound in bounds)),
            reduce(add, (bound.by_log_omega for _, bound in bounds)),
        )

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Return the sums of the terms' bounds of the changes."""
        bounds = [
            (self._ratio(term), term.variation(self._range_of(term, u_range), omega_range))
            for term in self.terms
        ]
        return GainVariation(
            reduce(add, (bound.by_u / ratio for ratio, bound in bounds)),
            reduce(add, (bound.by_log_omega for _, bound in bounds)),
        )

    def reach(self, u_range: Range, omega_range: Range | None = None) -> Reals | None:
        """Return the sum of the terms' bounds; None if none of them gives one."""
        bounds = [term.reach(self._range_of(term, u_range), omega_range) for term in self.terms]
        if all(bound is None for bound in bounds):
            return None
        half_width = 0.5 * np.subtract(u_range[1], u_range[0])
        total = np.zeros(range_shape(u_range, omega_range))
        for term, bound in zip(self.terms, bounds, strict=True):
            if bound is None:
                steepest = term.sensitivity(self._range_of(term, u_range), omega_range).by_u
                bound = steepest * half_width / self._ratio(term)
            total = total + bound
        return total[()]

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return the sum of the terms' gains for the mean."""
        return reduce(add, (term.mean_gain(amplitude) for term in self.terms))

    def _range_of(self, term: Element, u_range: Range) -> Range:
        lower, upper = u_range
        return np.divide(lower, self._ratio(term)), np.divide(upper, self._ratio(term))

    def _ratio(self, term: Element) -> float:
        """Return u of the sum over u of a term, at the same amplitude."""
        return self.amplitude_scale / term.amplitude_scale

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return reduce(add, (term._describing_function(amplitude, omega, harmonic) for term in self.terms))

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return reduce(add, (term._waveform(phase, amplitude, omega) for term in self.terms))

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        parts = [(self._ratio(term), term._expansion(amplitude, omega)) for term in self.terms]
        return Expansion(
            reduce(add, (part.value for _, part in parts)),
            reduce(add, (part.by_u / ratio for ratio, part in parts)),
            reduce(add, (part.by_log_omega for _, part in parts)),
        )
