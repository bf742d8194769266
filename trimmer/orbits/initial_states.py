"""Initial states from which long simulations look for stable orbits."""

import math
from collections.abc import Iterator

import numpy as np

from trimmer.arrays import Reals
from trimmer.loops import ClosedLoop, Feedback
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.relay_component import RelayComponent
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.loops.initial import segment_from

FARTHER = 3.0  # Factor by which the frequencies reach beyond the slowest and the fastest root
DECADES = (-1.0, 2.0)
"""Of the amplitude of the element's input over its gap or threshold, and of its output over that or level."""


def initial_states(loop: ClosedLoop | Feedback, count: int, seed: int) -> Iterator[tuple[int, Reals]]:
    """Draw modes and extended states, the same ones for the same seed.

    Each begins with a frequency between the slowest and the fastest root of the loop, and an amplitude. Every
    other state is one that the linear system would be in under a sinusoid of these; the others lie anywhere
    in the box that this sinusoid fills.

    Args:
        loop: The closed loop.
        count: How many.
        seed: Of the generator.
    """
    generator = np.random.default_rng(seed)
    slowest, fastest = _rates(loop)
    A, scales, channels = loop.model.A, _scales(loop), loop.element_sides
    for number in range(count):
        omega = math.exp(generator.uniform(math.log(slowest / FARTHER), math.log(fastest * FARTHER)))
        scale = scales[generator.integers(len(scales))]
        size = scale * 10.0 ** generator.uniform(*DECADES)
        # Slightly beside the axis, where an undamped mode would have no response.
        column, row = channels[number % len(channels)]
        response = np.linalg.solve((0.01 + 1j) * omega * np.eye(len(A)) - A, column)
        gain = abs(complex(row @ response))
        of_input = generator.random() < 0.5 and gain > 0
        response = response * (size / gain if of_input else size)
        phase, inside = generator.uniform(0.0, 2.0 * math.pi), generator.uniform(-1.0, 1.0, len(A))
        state = (response * np.exp(1j * phase)).real if number % 2 else abs(response) * inside
        play = scale * generator.uniform(-0.5, 0.5)
        yield segment_from(loop.modes, state, play + float(row @ state))


def quiet_time(loop: ClosedLoop | Feedback) -> float:
    """Return the time, s, after which a loop without events counts as being at rest."""
    return 100.0 * math.pi / _rates(loop)[0]


def _rates(loop: ClosedLoop | Feedback) -> tuple[float, float]:
    """Return the smallest and the largest modulus of a pole, of the system alone or in a rigid loop."""
    system = loop.modes.system.interconnection
    rigid = system.A + system.B @ system.C
    rates = abs(np.concatenate([np.linalg.eigvals(system.A), np.linalg.eigvals(rigid)]))
    rates = rates[rates > 1e-9 * rates.max(initial=0.0)]
    return (float(rates.min()), float(rates.max())) if rates.size else (1.0, 1.0)


def _scales(loop: ClosedLoop | Feedback) -> list[float]:
    """Return the gap, the thresholds or the level times its factor, of each component."""
    system = loop.modes.system.interconnection
    scales = []
    for component, factor in zip(system.components, system.element_factors, strict=True):
        if isinstance(component, BacklashComponent):
            scales.append(component.gap)
        elif isinstance(component, RelayComponent):
            scales.append(abs(factor) * component.level)
        elif isinstance(component, CornerComponent):
            scales.append(component.threshold)
        elif isinstance(component, ThresholdComponent):
            scales += [abs(factor) * component.level, component.on]
    return scales or [1.0]
