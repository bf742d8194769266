"""The picture of what a mechanism settles to, and of a simulated motion."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.drawing.axes import add_legend
from trimmer.drawing.content import head, new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.mechanisms.motions import draw_motion, draw_phase_plane, draw_section
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.results.response import Response, SettledMotion
from trimmer.response.simulation.motion import MechanismMotion

SIZE = (7.6, 7.2)
CLOSE = 0.05  # Share of the phase plane within which a section is shown in the frame of that
SHOWN = 8  # Drive periods that are shown of a motion that does not repeat


@draw.register(Response)
def draw_response(response: Response, axes: Axes) -> None:
    """Draw what the motion of the first start does over time."""
    draw_motion(*shown(response.motion), axes)


def response_figure(response: Response) -> Figure:
    """Draw the first motion over time and in the phase plane, and the Poincaré section of all motions."""
    flow, course = shown(response.motion)
    figure = new_figure(*SIZE)
    panels = figure.subplot_mosaic([["motion", "motion"], ["plane", "section"]], height_ratios=[4, 5])
    draw_motion(flow, course, panels["motion"])
    draw_phase_plane(flow, course, panels["plane"])
    panels["plane"].set_title("phase plane", fontsize="small")
    for number, motion in enumerate(response.motions):
        _add_section(panels["section"], motion, f"{number + 1}: {motion.share:.0%} of the starts", number)
    _frame(panels["section"], panels["plane"])
    counted = response.motion.window is None or flow.period
    times = "at the start of each drive period" if counted else "at equal steps of time"
    panels["section"].set_title(times, fontsize="small")
    if len(response.motions) > 1:
        add_legend(panels["section"])
    head(figure, response.subject.title)
    return figure


def _frame(section: Axes, plane: Axes) -> None:
    """Show as much as the phase plane does, where points lie so close together that they would look apart."""
    limits = plane.get_xlim(), plane.get_ylim()
    spans = [abs(high - low) for low, high in limits]
    sizes = section.dataLim.size
    if all(size < CLOSE * span for size, span in zip(sizes, spans, strict=True)):
        section.set(xlim=limits[0], ylim=limits[1])
        section.xaxis.set_major_formatter(plane.xaxis.get_major_formatter())
        section.set_xlabel(plane.get_xlabel(), parse_math=False)


def motion_figure(motion: MechanismMotion) -> Figure:
    """Draw a motion over time, with contact and stick marked, and its phase plane."""
    figure = new_figure(*SIZE)
    above, below = figure.subplots(2, height_ratios=[4, 5])
    draw_motion(motion.flow, motion.course, above, travels=True)
    draw_phase_plane(motion.flow, motion.course, below)
    head(figure, motion.mechanism.title)
    return figure


def shown(motion: SettledMotion) -> tuple[Flow, Course]:
    """Return the motion that is drawn: an orbit, rest, or some periods of what does not repeat."""
    if motion.orbit is not None:
        return motion.orbit.flow, motion.orbit.course
    if motion.rest is not None:
        return motion.rest.flow, motion.rest.course
    if motion.linear is not None:
        flow, limit = motion.linear.flow, motion.linear.limit
        slowest = 2 * np.pi / float(motion.linear.frequencies[0])
        return flow, flow.timed(limit, SHOWN * (flow.period or slowest))
    if motion.window is None:
        raise ValueError("nothing was found that could be drawn")
    window = motion.window
    if not window.flow.period:
        return window.flow, window.flow.timed(window.end, SHOWN * window.unit)
    return window.flow, window.flow.course(window.end, SHOWN)


def _add_section(axes: Axes, motion: SettledMotion, label: str, number: int) -> None:
    if motion.orbit is not None:
        draw_section(axes, motion.orbit.flow, motion.orbit.strobed, label, number)
    elif motion.window is not None:
        draw_section(axes, motion.window.flow, motion.window.states, label, number)
