"""The start of the search for an orbit from a prediction of harmonic balance, on its first harmonic."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.balance.many_harmonics.pieces import mode_on
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial
from trimmer.elements import DeadZone, Element, Preload, Relay, Saturation, ScaledElement, SumOfElements
from trimmer.loops.components.backlash_component import FREE, LOWER, UPPER, BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.relay_component import MINUS, PLUS, RelayComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.loops.loops import ClosedLoop

PHASES = 720  # Phases among which the one to start from is chosen
TOUCHING = 1e-9  # Distance from a side of the gap, relative to the gap, at which there is contact


@dataclass(frozen=True)
class Start:
    """Start of the search for an orbit."""

    mode: int  # Number of the mode of the loop
    state: Reals  # Of what moves, as in the extended state, whose constant is left out, shape (n,)
    sizes: Reals  # Largest modulus of each entry of the state along the orbit, estimated, shape (n,)


def starting_point(loop: ClosedLoop, amplitude: float, omega: float) -> Start:
    """Return the mode and the state in which the loop would be on its first harmonic.

    The phase is in the middle of a contact, of a half period of a relay, or of the longest time between two
    corners or thresholds, so that no event is near.

    Args:
        loop: The closed loop.
        amplitude: Amplitude of the element's input, in its unit.
        omega: Angular frequency, rad/s.
    """
    model, element, modes = loop.model, loop.element, loop.modes
    leaves = _leaves(element)
    phase = _quiet_phase(leaves, amplitude, omega)
    response = np.linalg.solve(1j * omega * np.eye(model.nstates) - model.A, model.B[:, 0])
    output = complex(element.describing_function(amplitude, omega)) * amplitude
    state, sizes = np.zeros(modes.system.layout.size), np.ones(modes.system.layout.size)
    state[: model.nstates] = (response * output * np.exp(1j * phase)).imag
    sizes[: model.nstates] = abs(response * output)
    for first, component in zip(
        modes.system.layout.first_states, modes.system.interconnection.components, strict=True
    ):
        count = component.state_count
        sizes[first : first + count] = amplitude * omega ** np.arange(count)
    chosen = tuple(
        _mode(component, leaf, phase, amplitude, omega)
        for component, leaf in zip(modes.system.interconnection.components, leaves, strict=True)
    )
    return Start(modes.number(chosen), state, sizes)


def _leaves(element: Element) -> list[Element]:
    """Return the elements of a sum, without their factors, in the order of their components."""
    match element:
        case SumOfElements():
            return [leaf for term in element.terms for leaf in _leaves(term)]
        case ScaledElement():
            return _leaves(element.element)
        case Preload():
            return [element, element]
    return [element]


def _quiet_phase(leaves: list[Element], amplitude: float, omega: float) -> float:
    """Return the middle of the upper contact of the first backlash, or a phase far from other events."""
    phases = np.linspace(-np.pi, np.pi, PHASES)
    for leaf in leaves:
        gap = getattr(leaf, "gap", None)
        if gap is None:
            continue
        distance = amplitude * np.sin(phases) - leaf.waveform(phases, amplitude, omega) - 0.5 * gap
        contact = phases[abs(distance) <= TOUCHING * gap]
        if contact.size:
            return float(contact[contact.size // 2])
    return _farthest_from_events([place for leaf in leaves for place in _events(leaf, amplitude)])


def _events(leaf: Element, amplitude: float) -> list[float]:
    """Return the phases at which a saturation, dead zone or relay with thresholds has its events, rad."""
    limits: tuple[float, ...] = ()
    match leaf:
        case Saturation() | DeadZone():
            limits = (leaf.threshold, leaf.threshold)
        case Relay() if leaf.thresholds is not None:
            limits = (leaf.thresholds.on, leaf.thresholds.off)
    if not limits or amplitude <= max(limits):
        return []
    rise, fall = np.arcsin(limits[0] / amplitude), np.pi - np.arcsin(limits[1] / amplitude)
    return [float(place) for place in (rise, fall, rise + np.pi, fall + np.pi)]


def _farthest_from_events(places: list[float]) -> float:
    """Return the middle of the longest time between phases, rad; an eighth of a period if there are none."""
    if not places:
        return 0.25 * np.pi
    rising = np.unique(np.mod(places, 2.0 * np.pi))
    lengths = np.diff(np.append(rising, rising[0] + 2.0 * np.pi))
    longest = int(np.argmax(lengths))
    return float(rising[longest] + 0.5 * lengths[longest])


def _mode(component: Component, leaf: Element, phase: float, amplitude: float, omega: float) -> int:
    """Return the mode of a component with a sinusoidal input at a phase, rad."""
    match component:
        case BacklashComponent():
            play = amplitude * np.sin(phase) - float(leaf.waveform(phase, amplitude, omega))
            if abs(abs(play) - 0.5 * component.gap) > TOUCHING * component.gap:
                return FREE
            return UPPER if play > 0 else LOWER
        case RelayComponent():
            return PLUS if (np.cos(phase) if component.of_rate else np.sin(phase)) > 0 else MINUS
        case CornerComponent() | ThresholdComponent():
            return mode_on(component, OddPolynomial(np.array([complex(amplitude)])), phase)
    return 0
