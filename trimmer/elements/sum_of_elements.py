"""A sum of elements that share one input."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import final

import numpy as np

from trimmer.arguments import require_instances
from trimmer.arrays import Complexes, Reals
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.kept_property import cached_property


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
        """Whether all terms have bounds, and N is bounded, or proportional to 1/A at all amplitudes."""
        return all(each.has_bounds for each in self._single_terms) and not self._grows_unevenly

    @property
    def _single_terms(self) -> tuple[Element, ...]:
        """The terms, those of sums among them."""
        found: tuple[Element, ...] = ()
        for term in self.terms:
            found += term._single_terms if isinstance(term, SumOfElements) else (term,)
        return found

    @cached_property
    def _grows_unevenly(self) -> bool:
        """Whether N grows without bound as the amplitude falls, and not like 1/A alone."""
        if self.depends_on_frequency or math.isfinite(min(float(self.domain()), self.constant_from)):
            return False
        amplitudes = self.amplitude_scale * np.array([1.0, 0.25, 3.0])
        first, *others = amplitudes * self.describing_function(amplitudes)
        return not np.allclose(others, first, rtol=1e-12, atol=0.0)

    @property
    def constant_from(self) -> float:
        """The largest of the terms' values, each in terms of the u of the sum."""
        return max(self._ratio(term) * term.constant_from for term in self.terms)

    def _domain(self, omega: Reals) -> Reals | float:
        """Return the smallest of the terms' suprema, each in terms of the u of the sum."""
        return reduce(np.minimum, (self._ratio(term) * term._domain(omega) for term in self.terms))

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return the sums of the terms' bounds: a modulus of a sum is at most the sum of the moduli."""
        return self._added([term._sensitivity(self._of_term(term, u), omega) for term in self.terms])

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return the sums of the terms' bounds of the changes."""
        return self._added([term._variation(self._of_term(term, u), omega) for term in self.terms])

    @property
    def _has_reach(self) -> bool:
        return any(term._has_reach for term in self.terms)

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        """Return the sum of the terms' bounds; where |dN/du| is one, that times half the width."""
        return reduce(add, (self._reach_of(term, self._of_term(term, u), omega) for term in self.terms))

    def _reach_of(self, term: Element, u: Limits, omega: Limits) -> Reals:
        if term._has_reach:
            return term._reach(u, omega)
        steepest, _ = term._sensitivity(u, omega)
        return np.asarray(steepest * 0.5 * (u[1] - u[0]))

    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        """Return the sum of the terms' gains for the mean."""
        return reduce(add, (term._mean_gain(amplitude) for term in self.terms))

    def _added(self, bounds: Sequence[Bounds]) -> Bounds:
        """Add the terms' bounds by u and by ln omega, the former in terms of the u of the sum."""
        by_u = (bound / self._ratio(term) for term, (bound, _) in zip(self.terms, bounds, strict=True))
        return reduce(add, by_u), reduce(add, (bound for _, bound in bounds))

    def _of_term(self, term: Element, u: Limits) -> Limits:
        return u[0] / self._ratio(term), u[1] / self._ratio(term)

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
