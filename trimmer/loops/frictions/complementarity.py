"""Which relays and frictions go on holding at an instant, and where the others go: by complementarity.

The integration decides it event by event, and mostly comes to an end. Where its events repeat each other at
one instant, this decides for all at once.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.dry_friction import complementary_forces, elementary_vectors
from trimmer.loops.components.relay_component import HELD, MINUS, PLUS, RelayComponent
from trimmer.loops.frictions.coupled_relays import direction, symmetrizing_scales

if TYPE_CHECKING:
    from trimmer.arrays import Places, Reals
    from trimmer.loops.system import LoopSystem


CANCELLED = 1e-11  # A sum below this share of the moduli of its terms is zero


@dataclass(frozen=True, eq=False)
class _AtRest:
    """Relays whose switching functions are zero at an instant."""

    relays: tuple[int, ...]  # Their numbers among the components
    directions: Reals  # What their switching functions are made of
    influence: Reals  # Of their forces, the outputs times scales, on the rates of the switching functions
    scales: Reals  # These
    levels: Reals  # Of the forces of what slides
    limits: Reals  # Of the forces of what is held


def complementary_mode(
    system: LoopSystem,
    statuses: tuple[int, ...],
    state: Reals,
    relays: tuple[int, ...],
    before: tuple[int, ...],
    broken: tuple[int, ...] = (),
) -> tuple[int, ...] | None:
    """Return the modes of all components in which relays go on whose switching functions are zero.

    What breaks away has its kinetic force from then on, and all is decided again: it may be held after
    all, where others that broke away with it push it back. What was held ``before`` the instant goes on
    being held if it can. First the rates of the switching functions decide, by the complementarity problem
    of ``trimmer.hybrid.dry_friction``. Where they are zero and what is held is at a limit of all, the next
    derivatives do, as often as needed. None if the outputs have no symmetric influence, as those of bodies
    have.
    """
    chosen = tuple(PLUS if k in relays else status for k, status in enumerate(statuses))
    at_rest = _at_rest(system, chosen, relays, broken)
    while at_rest is not None:
        decided = _decided(system, at_rest, chosen, state)
        moves = np.array([decided[k] != HELD for k in at_rest.relays])
        breaking = moves & (at_rest.limits > at_rest.levels)
        if not breaking.any():
            return decided
        # What turns back never had its static force, with which it would tear off what is held.
        turning = breaking & np.array([k not in before for k in at_rest.relays])
        breaking = turning if turning.any() else breaking
        at_rest = replace(at_rest, limits=np.where(breaking, at_rest.levels, at_rest.limits))
    return None


def _decided(
    system: LoopSystem, at_rest: _AtRest, statuses: tuple[int, ...], state: Reals
) -> tuple[int, ...]:
    """Return the modes of all components, with the present limits of what may be held."""
    mode, chosen = system.mode(statuses), list(statuses)
    rows = np.array([_switching(system, statuses, k) for k in at_rest.relays])
    drift = rows @ mode.flow @ state + at_rest.influence @ at_rest.levels
    noise = CANCELLED * (abs(rows) @ abs(mode.flow) @ abs(state))
    every = np.arange(len(at_rest.relays))
    held = _distribute(at_rest, every, drift, (-at_rest.limits, at_rest.limits), noise, chosen)
    for derivative in range(1, system.layout.order + 1):
        bounds = _bounds_of_rates(system, at_rest, held, state, derivative, tuple(chosen))
        if bounds is None:
            break
        forces, sizes = _forces(system, at_rest, held, state, derivative, tuple(chosen))
        influence = at_rest.influence[np.ix_(held, held)]
        noise = CANCELLED * (abs(influence) @ sizes)
        held = _distribute(at_rest, held, influence @ forces, bounds, noise, chosen)
    return tuple(chosen)


def _at_rest(
    system: LoopSystem, chosen: tuple[int, ...], relays: tuple[int, ...], broken: tuple[int, ...]
) -> _AtRest | None:
    if not relays:
        return None
    rows = np.array([_switching(system, chosen, k)[: system.layout.order] for k in relays])
    influence = -rows @ system.interconnection.B[:, list(relays)]
    scales = symmetrizing_scales(influence)
    if scales is None:
        return None
    components = [system.interconnection.components[k] for k in relays]
    levels = np.array([each.level for each in components if isinstance(each, RelayComponent)])
    statics = np.array([each.static for each in components if isinstance(each, RelayComponent)])
    limits = np.where(np.isin(relays, broken), levels, statics)
    directions = np.array([direction(system.interconnection, k) for k in relays])
    return _AtRest(relays, directions, influence / scales, scales, levels * scales, limits * scales)


def _distribute(
    at_rest: _AtRest, held: Places, drift: Reals, bounds: tuple[Reals, Reals], noise: Reals, chosen: list[int]
) -> Places:
    """Choose the modes of what is held by the sign with which each leaves zero; return what stays held."""
    influence = at_rest.influence[np.ix_(held, held)]
    _, rates = complementary_forces(influence, drift, *bounds, noise)
    for each, rate in zip(held, rates, strict=True):
        chosen[at_rest.relays[each]] = HELD if rate == 0.0 else PLUS if rate > 0.0 else MINUS
    still: Places = held[rates == 0.0]
    return still


def _bounds_of_rates(
    system: LoopSystem, at_rest: _AtRest, held: Places, state: Reals, derivative: int, chosen: tuple[int, ...]
) -> tuple[Reals, Reals] | None:
    """Return where a derivative of the forces may go; None if inside all facets, or without any."""
    if not held.size:
        return None
    vectors = elementary_vectors(at_rest.directions[held])
    vectors = np.vstack([vectors, -vectors])
    touched = np.ones(len(vectors), dtype=bool)
    for order in range(derivative):
        forces, sizes = _forces(system, at_rest, held, state, order, chosen)
        bound = abs(vectors) @ at_rest.limits[held] if order == 0 else 0.0
        touched &= abs(bound - vectors @ forces) <= CANCELLED * (bound + abs(vectors) @ sizes)
    if not touched.any():
        return None
    upper = np.where((vectors[touched] > 0).any(axis=0), 0.0, np.inf)
    lower = np.where((vectors[touched] < 0).any(axis=0), 0.0, -np.inf)
    return lower, upper


def _forces(
    system: LoopSystem, at_rest: _AtRest, held: Places, state: Reals, order: int, chosen: tuple[int, ...]
) -> tuple[Reals, Reals]:
    """Return a derivative in time of the forces that hold, and the sizes of the terms of each."""
    mode = system.mode(chosen)
    rows = np.array([at_rest.scales[each] * mode.signals[at_rest.relays[each]].output for each in held])
    sizes = abs(rows)
    for _ in range(order):
        rows, sizes = rows @ mode.flow, sizes @ abs(mode.flow)
    return rows @ state, sizes @ abs(state)


def _switching(system: LoopSystem, chosen: tuple[int, ...], k: int) -> Reals:
    return system.interconnection.components[k].switching_function(system.mode(chosen).signals[k])
