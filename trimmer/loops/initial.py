"""Where a motion starts: the extended state and the modes that fit it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import finite_number, real_values
from trimmer.loops.components.relay_component import HELD
from trimmer.loops.frictions.complementarity import complementary_mode
from trimmer.loops.frictions.coupled_relays import attracting
from trimmer.loops.interconnection import acts

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Reals
    from trimmer.loops.loops import Loop
    from trimmer.loops.mode import LoopMode
    from trimmer.loops.system import LoopModes


def initial_segment(
    loop: Loop, modes: LoopModes, initial_state: ArrayLike | None, impulse: float, element_output: float
) -> tuple[int, Reals]:
    """Return the number of the mode, and the extended state, (n,), at t = 0, after an impulse."""
    started = _plant_state(loop, initial_state, impulse)
    return segment_from(modes, started, finite_number("element_output", element_output))


def segment_from(modes: LoopModes, plant_state: Reals, element_output: float) -> tuple[int, Reals]:
    """Return mode and extended state of states of the plant, (n,), and an output where one can be chosen."""
    layout = modes.system.layout
    state = np.zeros(layout.size)
    state[: layout.order] = plant_state
    state[layout.sine :] = layout.forcing_at(0.0)
    return modes.number(_chosen(modes, state, element_output)), state


def resumed(
    modes: LoopModes, extended: Reals, anew: bool = False
) -> tuple[tuple[int, ...], Reals, tuple[int, ...]]:
    """Return the statuses that go with an extended state, (n,), and the state as it fits them.

    Of the relays and frictions at rest all decide at once whether they are held. Those that are not are
    told too, by their numbers: their switching functions are zero.
    """
    system, state = modes.system, extended.copy()
    statuses = _chosen(modes, state, 0.0 if anew else None)
    state = modes[modes.number(statuses)].hold @ state
    held = tuple(k for k, one in enumerate(statuses) if one == HELD and attracting(system.interconnection, k))
    decided = complementary_mode(system, statuses, state, held, ()) or statuses
    return decided, state, tuple(k for k in held if decided[k] != HELD)


def _chosen(modes: LoopModes, state: Reals, element_output: float | None) -> tuple[int, ...]:
    """Return statuses chosen for one component after the other; states stay where no output is asked."""
    system, layout = modes.system, modes.system.layout
    chosen = [0] * system.part_count
    for k, component in enumerate(system.interconnection.components):
        # Each sees the outputs of those before it.
        mode = system.mode(tuple(chosen))
        signals = mode.signals[k]
        own = slice(layout.first_states[k], layout.first_states[k] + component.state_count)
        switching = _leading_value(component.switching_function(signals), mode, modes, k, state)
        value = float(signals.input @ state)
        if element_output is None:
            chosen[k] = component.resumed(value, switching, state[own])
        else:
            chosen[k], state[own] = component.initial(value, switching, element_output)
    return system.coupled.closed(tuple(chosen))


def _plant_state(loop: Loop, initial_state: ArrayLike | None, impulse: float) -> Reals:
    model = loop.model
    state = np.array([loop.start.get(name, 0.0) for name in model.state_labels])
    if initial_state is not None:
        if not loop.has_states:
            raise ValueError(
                "initial_state: a transfer function has no states of its own; give a control.StateSpace"
            )
        state = real_values("initial_state", initial_state).copy()
        if state.shape != (model.nstates,):
            raise ValueError(f"initial_state must have shape ({model.nstates},), not {state.shape}")
        if not np.isfinite(state).all():
            raise ValueError("initial_state must be finite")
    started: Reals = state + model.B[:, 0] * finite_number("impulse", impulse)
    return started


def _leading_value(row: Reals, mode: LoopMode, modes: LoopModes, k: int, state: Reals) -> float:
    """Return a row's value, or its first derivative in time that is not zero before the output acts on it."""
    push = np.zeros(state.size)
    push[: modes.system.layout.order] = modes.system.interconnection.B[:, k]
    for _ in range(modes.system.layout.order + 1):
        value = float(row @ state)
        if abs(value) > 1e-14 * float(abs(row) @ abs(state)):
            return value
        if acts(row, push):
            break
        row = row @ mode.flow
    return 0.0
