"""What results inherit to draw themselves."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Drawn:
    """A result that is a picture too; the docstring of its class says what the picture shows."""

    __slots__ = ()

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the result with Matplotlib, as the docstring of its class says.

        Args:
            ax: Where to draw; new axes if not given.

        Returns:
            The axes, so that more can be drawn into them.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
            ValueError: if there is nothing in the result that could be drawn.
        """
        return drawn(self, ax)


def drawn(result: object, ax: Axes | None, **options: Any) -> Axes:
    """Draw a result, with options of its own picture; arguments and errors are those of ``Drawn.plot``."""
    # By its name, because a picture imports the result that it shows.
    axes: Axes = import_module("trimmer.drawing.dispatch").plot(result, ax, **options)
    return axes
