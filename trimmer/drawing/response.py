"""The picture of what a mechanism settles to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from trimmer.drawing.content import content_of
from trimmer.drawing.motions import draw_motion, draw_phase_plane, draw_section, draw_statuses

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.contact.flow import Course, ExactFlow
    from trimmer.response.response import Response, SettledMotion

SIZE = (7.2, 7.2)
SHOWN = 8
"""Drive periods that are shown of a motion that does not repeat."""


def draw_response(response: Response, file_format: str) -> bytes:
    """Draw the first motion over time and in the phase plane, and the Poincaré section of all motions.

    Args:
        response: What was found; its first motion could be followed.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    flow, course = shown(response.motion)
    figure = Figure(figsize=SIZE, layout="constrained")
    panels = figure.subplot_mosaic(
        [["motion", "motion"], ["statuses", "statuses"], ["plane", "section"]], height_ratios=[3, 1, 4]
    )
    panels["motion"].set_title(response.mechanism.title, fontsize="medium", parse_math=False)
    panels["motion"].set_xlim(0.0, course.duration)
    draw_motion(panels["motion"], flow, course)
    draw_statuses(panels["statuses"], flow, course)
    draw_phase_plane(panels["plane"], flow, course)
    panels["plane"].set_title("phase plane", fontsize="small")
    for number, motion in enumerate(response.motions, start=1):
        _add_section(panels["section"], motion, f"{number}: {motion.share:.0%} of the starts")
    panels["section"].set_title("at the start of each drive period", fontsize="small")
    if len(response.motions) > 1:
        panels["section"].legend(fontsize="x-small")
    return content_of(figure, file_format)


def shown(motion: SettledMotion) -> tuple[ExactFlow, Course]:
    """Return the motion that is drawn: an orbit, or some periods of what does not repeat.

    Raises:
        ValueError: if there is none.
    """
    if motion.orbit is not None:
        return motion.orbit.flow, motion.orbit.course
    if motion.window is None:
        raise ValueError("nothing was found that could be drawn")
    return motion.window.flow, motion.window.flow.course(motion.window.end, SHOWN)


def _add_section(axes: Axes, motion: SettledMotion, label: str) -> None:
    if motion.orbit is not None:
        draw_section(axes, motion.orbit.flow, motion.orbit.strobed, label)
    elif motion.window is not None:
        draw_section(axes, motion.window.flow, motion.window.states, label)
