"""The motion of a loop over time, with contact and stick marked."""

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Reals
from trimmer.drawing.axes import finish
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import line
from trimmer.drawing.strips import strips_of
from trimmer.loops import Feedback, LoopMotion
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.flow import LoopFlow

POINTS = 4000  # Points of a curve, beside the events
MOST_EVENTS = 2000  # Events up to which each is a point of the curves too


@draw.register(LoopMotion)
def draw_loop_motion(motion: LoopMotion, axes: Axes) -> None:
    """Draw output, and of a play its input and output, over time."""
    times = np.linspace(0.0, motion.duration, POINTS)
    if len(motion.log.start) <= MOST_EVENTS:
        times = np.union1d(times, motion.log.start[motion.log.start <= motion.duration])
    for number, (name, values) in enumerate(signals_of(motion, times).items()):
        axes.plot(times, values, label=name, linewidth=1.2, **line(number))
    axes.set_xlim(0.0, motion.duration)
    unit = motion.loop.length
    strips = strips_of(LoopFlow(motion.loop).parts, motion.loop.modes, motion.log, motion.duration)
    finish(axes, ("time", "s"), ("displacement" if unit else "signals", unit), strips)


def signals_of(motion: LoopMotion, times: Reals) -> dict[str, Reals]:
    """Return what is drawn of a loop at times, s: its output, and of a play its input and its output.

    Of a ``Feedback`` all outputs of the plant are drawn.

    Without a drive the input of the play is less the output of the loop, and is left out.
    What an element gives that is no play is a force or of another unit, and is left out.
    """
    if isinstance(motion.loop, Feedback):
        return {name: motion.signal(name, times) for name in motion.loop.plant.output_labels}
    drawn = {f"output {motion.loop.model.output_labels[0]}": motion.output(times)}
    if isinstance(motion.loop.modes.system.interconnection.components[0], BacklashComponent):
        if motion.loop.modes.system.interconnection.drives:
            drawn["input of the play"] = motion.element_input(times)
        drawn["output of the play"] = motion.element_output(times)
    return drawn
