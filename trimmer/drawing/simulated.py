"""The picture of a simulated motion of a mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from trimmer.drawing.content import content_of
from trimmer.drawing.motions import draw_motion, draw_phase_plane, draw_statuses

if TYPE_CHECKING:
    from trimmer.response.motion import MechanismMotion

SIZE = (7.2, 7.2)


def draw_simulated(motion: MechanismMotion, file_format: str) -> bytes:
    """Draw a motion over time, with contact and stick marked, and its phase plane.

    Args:
        motion: The motion.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    figure = Figure(figsize=SIZE, layout="constrained")
    above, middle, below = figure.subplots(3, height_ratios=[3, 1, 4])
    above.set_title(motion.mechanism.title, fontsize="medium", parse_math=False)
    above.set_xlim(0.0, motion.duration)
    draw_motion(above, motion.flow, motion.course)
    draw_statuses(middle, motion.flow, motion.course)
    draw_phase_plane(below, motion.flow, motion.course)
    return content_of(figure, file_format)
