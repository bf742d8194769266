"""Relays and frictions whose switching functions depend on each other, as those of a ring of three bodies.

Where they are all held, the motion determines the resultant of their outputs and not how they share it
(``trimmer.hybrid.dry_friction``). So what ends the hold belongs to all of them: one event function
for each side of each facet, at which several begin to slide at once. And where some are held, others may be
held too, because their velocities follow from those.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.hybrid.dry_friction import DEPENDENT, admissible_split, closure, elementary_vectors
from trimmer.loops.components.relay_component import HELD, RelayComponent
from trimmer.loops.interconnection import Interconnection, effect


@dataclass(frozen=True, eq=False)
class CoupledRelays:
    """The relays of an interconnection that depend on each other."""

    members: tuple[int, ...]  # Their numbers among the components, ascending; none if all are independent
    directions: Reals  # D, (m, n): their switching functions are its rows times something that moves
    scales: Reals  # (m,): times these, their outputs have a symmetric influence on each other, as forces have
    levels: Reals  # Largest outputs with which they hold, (m,)

    @classmethod
    def of(cls, system: Interconnection) -> CoupledRelays:
        """Find them; relays whose output does not work against their own rate are never held together."""
        relays = [k for k in range(len(system.components)) if attracting(system, k)]
        members, directions = _dependent(relays, [direction(system, k) for k in relays])
        influence = np.array([[_row(system, i) @ system.B[:, j] for j in members] for i in members])
        scales = symmetrizing_scales(influence.reshape(2 * (len(members),)))
        if scales is None:
            nothing = np.array([])
            return cls((), nothing, nothing, nothing)
        return cls(members, directions, scales, np.array([_level(system, k) for k in members]))

    def held(self, component_modes: tuple[int, ...]) -> Flags:
        """Return which members are held."""
        return np.array([component_modes[k] == HELD for k in self.members], dtype=bool)

    def closed(self, component_modes: tuple[int, ...]) -> tuple[int, ...]:
        """Return the mode in which those are held too whose switching functions follow from held ones."""
        held = self.held(component_modes)
        if not held.any():
            return component_modes
        closed = list(component_modes)
        for each in np.flatnonzero(closure(self.directions, held)):
            closed[self.members[each]] = HELD
        return tuple(closed)

    def facets(self, component_modes: tuple[int, ...]) -> Iterator[tuple[Reals, float]]:
        """Yield vectors y and bounds, of both signs: held members can hold while y · outputs <= bound.

        Where that ends, those with y > 0 go on to a positive output, those with y < 0 to a negative
        one.
        """
        held = tuple(np.flatnonzero(self.held(component_modes)).tolist())
        for vector in self._facets[held] if held else ():
            bound = float(abs(vector) @ self.levels)
            yield vector, bound
            yield -vector, bound

    def shared(self, component_modes: tuple[int, ...], outputs: Reals) -> Reals:
        """Return the outputs of all components, those of held members shared within their levels."""
        held = np.flatnonzero(self.held(component_modes))
        if held.size < 2:
            return outputs
        members = [self.members[each] for each in held]
        scales, levels = self.scales[held], self.levels[held]
        split = admissible_split(self.directions[held], levels * scales, outputs[members] * scales)
        shared = outputs.copy()
        if split is not None:
            shared[members] = split / scales
        return shared

    @cached_property
    def _facets(self) -> _Facets:
        return _Facets(self.directions, self.scales)


class _Facets(dict[tuple[int, ...], "Reals"]):
    """Elementary vectors of the held ones among m directions, as rows of length m; found when first asked."""

    def __init__(self, directions: Reals, scales: Reals) -> None:
        self._directions, self._scales = directions, scales

    def __missing__(self, held: tuple[int, ...]) -> Reals:
        of_held = elementary_vectors(self._directions[list(held)])
        vectors = np.zeros((len(of_held), len(self._directions)))
        vectors[:, list(held)] = of_held * self._scales[list(held)]
        vectors /= abs(vectors).max(axis=1, keepdims=True)
        self[held] = vectors
        return vectors


def _dependent(relays: list[int], directions: list[Reals]) -> tuple[tuple[int, ...], Reals]:
    """Return those whose direction is a combination of the others', and the directions of these."""
    if not relays:
        return (), np.array([])
    rows = np.array(directions)
    left, values, _ = np.linalg.svd(rows / np.linalg.norm(rows, axis=1)[:, None])
    free = left[:, int((values > DEPENDENT * values[0]).sum()) :]
    dependent = np.asarray((abs(free) > DEPENDENT).any(axis=1))
    return tuple(k for k, each in zip(relays, dependent, strict=True) if each), rows[dependent]


def symmetrizing_scales(influence: Reals) -> Reals | None:
    """Return s > 0 for which an influence, (m, m), over s by column is symmetric; None if none is."""
    scales, unknown = np.ones(len(influence)), set(range(len(influence)))
    noise = DEPENDENT * np.sqrt(np.outer(influence.diagonal(), influence.diagonal()))
    while unknown:
        reached = [unknown.pop()]
        while reached:
            i = reached.pop()
            for j in [j for j in unknown if abs(influence[i, j]) > noise[i, j]]:
                ratio = influence[i, j] / influence[j, i] if influence[j, i] else 0.0
                if ratio <= 0.0:
                    return None
                scales[j] = scales[i] * ratio
                unknown.remove(j)
                reached.append(j)
    scaled = influence / scales
    size = np.sqrt(np.outer(scaled.diagonal(), scaled.diagonal()))
    return scales if (scaled - scaled.T <= DEPENDENT * size).all() else None


def _row(system: Interconnection, k: int) -> Reals:
    """Return the switching function of a relay over the states of the plant, as far as the plant gives it."""
    component = system.components[k]
    assert isinstance(component, RelayComponent)
    row: Reals = system.C[k] @ system.A if component.of_rate else system.C[k]
    return row


def direction(system: Interconnection, k: int) -> Reals:
    """Return what the switching function is made of; those of inputs and of rates are independent."""
    row = np.concatenate([system.C[k], system.drive_gain[k]])
    component = system.components[k]
    assert isinstance(component, RelayComponent)
    nothing = np.zeros_like(row)
    return np.concatenate([row, nothing] if component.of_rate else [nothing, row])


def _level(system: Interconnection, k: int) -> float:
    component = system.components[k]
    assert isinstance(component, RelayComponent)
    return component.static


def attracting(system: Interconnection, k: int) -> bool:
    """Return whether a component is a relay whose output works against the rate of its switching function."""
    return isinstance(system.components[k], RelayComponent) and (
        effect(_row(system, k), system.B[:, k]) < 0.0
    )
