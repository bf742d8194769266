"""A loop of which motion in time is not known: its plant is known by frequency-response data."""

from dataclasses import dataclass

from trimmer.elements.element import Element
from trimmer.linear.measured_response import MeasuredResponse


@dataclass(frozen=True, eq=False)
class MeasuredLoop:
    """An element in negative feedback with a plant that is known by data."""

    system: MeasuredResponse
    element: Element
