"""The picture of a step: reference and output over time, below what acts, with contact and stick marked."""

import numpy as np
from matplotlib.figure import Figure

from trimmer.contact.readouts.control_readouts import control_signal
from trimmer.drawing.axes import finish
from trimmer.drawing.content import head, new_figure
from trimmer.drawing.look import line, plain_label
from trimmer.drawing.mechanisms.motions import POINTS, WORDS
from trimmer.drawing.strips import strips_of
from trimmer.motion.signals import along
from trimmer.response.step.step import StepResponse

SIZE = (7.6, 6.6)


def step_figure(response: StepResponse) -> Figure:
    """Draw how a controlled mechanism follows a step."""
    course, flow, step = response.motion.course, response.motion.flow, response.step
    until, figure = response.shown_until, new_figure(*SIZE)
    above, below = figure.subplots(2, height_ratios=[3, 2], sharex=True)
    times = np.union1d(np.linspace(0.0, until, POINTS), course.log.start)
    times = times[times <= until]
    rows, states = course.at(times)
    output, control = flow.outputs[response.output].signal, control_signal(flow.modes, response.controller)
    wanted = step.reference(times)
    above.plot(times, wanted, drawstyle="steps-post", label=response.reference, linewidth=1.0, **line(0))
    for axes, name, signal, number in (
        (above, response.output, output, 1),
        (below, response.controller, control, 2),
    ):
        values = along(course, signal, rows, states)
        axes.plot(times, values, label=plain_label(name), linewidth=1.2, **line(number))
    above.set_xlim(0.0, until)
    length, force = response.units
    finish(above, ("time", "s"), (WORDS.get(length, "signals"), length), [])
    strips = strips_of(flow.parts, course.modes, course.log, course.duration)
    finish(below, ("time", "s"), (WORDS.get(force, "control"), force), strips)
    head(figure, response.motion.mechanism.title)
    return figure
