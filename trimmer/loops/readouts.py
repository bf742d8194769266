"""What is read of the parts of a loop: phases, impacts behind a backlash, and what friction takes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.system import OWN_KINDS
from trimmer.loops.components import corner_component, relay_component, threshold_component
from trimmer.loops.components.backlash_component import LOWER, UPPER, BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.relay_component import HELD, RelayComponent
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.loops.mode import LoopMode
from trimmer.motion.part import Part, Phase
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import along, share_of_time, while_status

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.components.switched_component import Component
    from trimmer.motion.course import Course

IMPACT = OWN_KINDS  # The kind of an event at which a pin meets a side of its gap


def part_of(label: str, component: Component) -> Part:
    """Return a component of a loop as a part, by the phases that its modes are."""
    modes = range(len(component.mode_names))
    mirror = {mode: component.mirrored(mode) for mode in modes if component.mirrored(mode) != mode}
    return Part(label, _phases(component), mirror)


def _phases(component: Component) -> dict[int, Phase]:
    match component:
        case BacklashComponent():
            return {UPPER: Phase.UPPER, LOWER: Phase.LOWER}
        case RelayComponent(rubs=True):
            return {HELD: Phase.STICK}
        case RelayComponent():
            return {relay_component.PLUS: Phase.ABOVE, relay_component.MINUS: Phase.BELOW, HELD: Phase.STICK}
        case ThresholdComponent():
            return {threshold_component.POSITIVE: Phase.ABOVE, threshold_component.NEGATIVE: Phase.BELOW}
        case CornerComponent():
            return {corner_component.ABOVE: Phase.ABOVE, corner_component.BELOW: Phase.BELOW}
    return {}


def contact_measures(course: Course, part: int, periods: int) -> ContactMeasures:
    """Return what pin and load of a backlash do over a motion that spans some periods."""
    made = np.flatnonzero((course.log.part == part) & (course.log.kind == IMPACT))
    speeds = tuple(_approach(course, part, int(row)) for row in made)
    share = share_of_time(course, while_status(course, part, (UPPER, LOWER)))
    return ContactMeasures(len(speeds) / periods, speeds, None, share, 0.0)


def _approach(course: Course, part: int, row: int) -> float:
    """Return how fast pin and load approach each other just before the event that begins a row of the log."""
    mode = course.modes[int(course.log.mode[row - 1])]
    assert isinstance(mode, LoopMode)
    play = mode.signals[part].input - mode.signals[part].output
    return abs(float(play @ mode.flow @ course.before(row)))


def friction_measures(course: Course, part: int, periods: int) -> FrictionMeasures:
    """Return what a dry friction does over a motion that spans some periods."""
    modes, nodes = course.modes, course.nodes
    friction: RelayComponent = modes.system.interconnection.components[part]

    def sliding(number: int) -> Reals:
        mode = modes[number]
        assert isinstance(mode, LoopMode)
        return friction.switching_function(mode.signals[part])

    speeds = abs(along(course, sliding, nodes.rows, nodes.states))
    sticking = while_status(course, part, (HELD,))
    lost = friction.level * float(nodes.weights @ np.where(sticking[nodes.rows], 0.0, speeds))
    return FrictionMeasures(lost / periods, lost / course.duration, share_of_time(course, sticking))
