"""Symbols of plays, stops, frictions and pins, on a canvas in inches."""

from matplotlib.axes import Axes

from report.pages.drawing.marks import arrow
from report.pages.drawing.mechanical_symbols import LINE, damper, spring
from report.pages.drawing.style import BLACK, LINES
from trimmer.mechanism.parts import Contact, Link

HEIGHT = 0.13  # Half of the height of a slot
LEVEL = 0.11  # Distance of a spring and the damper beside it from the middle of their lane
ROUND = 0.22  # Radius of the corners of a body that turns
CONTACT = {**LINE, "color": LINES[1]["color"], "linewidth": 1.4}
FRICTION = {**LINE, "color": LINES[2]["color"], "linewidth": 1.8}


def spring_and_damper(axes: Axes, left: float, right: float, y: float, part: Link | Contact) -> None:
    """Draw what a link or a contact is made of, side by side if it is both."""
    springs = part.stiffness or getattr(part, "curve", None)
    if springs and part.damping:
        inner = 0.12 * (right - left)
        for x, end in ((left, left + inner), (right, right - inner)):
            axes.plot([x, end], [y, y], **LINE)
            axes.plot([end, end], [y - LEVEL, y + LEVEL], **LINE)
        spring(axes, left + inner, right - inner, y + LEVEL, "")
        damper(axes, left + inner, right - inner, y - LEVEL, "")
    elif springs:
        spring(axes, left, right, y, "")
    else:
        damper(axes, left, right, y, "")


def slot(axes: Axes, left: float, right: float, y: float) -> None:
    """Draw a slot with a bar in it that has room on both sides."""
    middle, width = 0.5 * (left + right), right - left
    first, last = middle - 0.3 * width, middle + 0.3 * width
    axes.plot([left, middle], [y, y], **CONTACT)
    axes.plot([middle, middle], [y - 0.6 * HEIGHT, y + 0.6 * HEIGHT], **CONTACT)
    for level in (y + HEIGHT, y - HEIGHT):
        axes.plot([first, last], [level, level], **CONTACT)
    # The near wall has a door for the bar's rod.
    axes.plot([first, first], [y + HEIGHT, y + 0.04], **CONTACT)
    axes.plot([first, first], [y - 0.04, y - HEIGHT], **CONTACT)
    axes.plot([last, last], [y - HEIGHT, y + HEIGHT], **CONTACT)
    axes.plot([last, right], [y, y], **CONTACT)


def stop(axes: Axes, left: float, right: float, y: float, *, pulls: bool) -> None:
    """Draw a stop: two plates that press on each other, or two hooks, as it acts while its ends are apart."""
    middle, gap = 0.5 * (left + right), 0.16 * (right - left)
    if not pulls:
        for x, end in ((middle - gap, left), (middle + gap, right)):
            axes.plot([end, x], [y, y], **CONTACT)
            axes.plot([x, x], [y - HEIGHT, y + HEIGHT], **CONTACT)
        return
    for sign, end, level in ((1, left, HEIGHT), (-1, right, -HEIGHT)):
        tip = middle + sign * gap
        axes.plot([end, tip], [y + level / 2, y + level / 2], **CONTACT)
        axes.plot([tip, tip], [y + level / 2, y - level / 2 - 0.02 * sign], **CONTACT)


def wall(axes: Axes, left: float, right: float, y: float, *, pulls: bool) -> None:
    """Draw a rigid wall: a stop without a spring, hatched behind one of its plates."""
    stop(axes, left, right, y, pulls=pulls)
    x = 0.5 * (left + right) + (0.16 if not pulls else -0.16) * (right - left)
    towards = 0.05 if not pulls else -0.05
    for share in (-0.9, -0.45, 0.0, 0.45, 0.9):
        level = y + share * HEIGHT if not pulls else y - HEIGHT / 2 + share * HEIGHT / 2
        axes.plot([x, x + towards], [level, level - 0.04], **(CONTACT | {"linewidth": 0.8}))


def sliding(axes: Axes, left: float, right: float, y: float) -> None:
    """Draw dry friction: two plates, one on the other."""
    middle, half, step = 0.5 * (left + right), 0.3 * (right - left), 0.03
    for sign, end, level in ((-1, left, y + step), (1, right, y - step)):
        edge = middle + sign * half
        axes.plot([end, edge, edge, middle - sign * 0.6 * half], [y, y, level, level], **FRICTION)
    for share in (-0.4, 0.0, 0.4):
        x = middle + share * half
        axes.plot([x - 0.04, x + 0.04], [y + step + 0.09, y + step + 0.02], **(FRICTION | {"linewidth": 0.8}))


def actuator(axes: Axes, left: float, right: float, y: float) -> None:
    """Draw what a controller acts with: a circle with its force u."""
    middle, radius = 0.5 * (left + right), 0.13
    axes.plot([left, middle - radius], [y, y], **LINE, zorder=1)
    axes.plot([middle + radius, right], [y, y], **LINE, zorder=1)
    disc(axes, (middle - radius, y - radius), (2 * radius, 2 * radius), "white")
    axes.text(middle, y, "u", ha="center", va="center", fontsize=8, style="italic", zorder=4)


def pin(axes: Axes, edge: float, y: float, sign: int, length: float) -> float:
    """Draw a pin that moves on a body, a length from its edge, right (1) or left (-1); return where it is."""
    at = edge + sign * length
    ends = sorted((edge + sign * 0.03, at - sign * 0.07))
    arrow(axes, (ends[0], y), (ends[1], y), shrinkA=0, shrinkB=0, mutation_scale=6, arrowstyle="<|-|>")
    axes.plot([at], [y], "o", color=BLACK, markerfacecolor="#bbbbbb", markersize=7, zorder=4)
    return at


def disc(axes: Axes, corner: tuple[float, float], size: tuple[float, float], fill: str) -> None:
    """Draw a body that turns, from its lower left corner: round where a body that moves has corners."""
    from matplotlib.patches import FancyBboxPatch

    style = f"round,pad=0,rounding_size={min(ROUND, *(0.5 * each for each in size))}"
    patch = FancyBboxPatch(
        corner, *size, boxstyle=style, facecolor=fill, edgecolor=BLACK, linewidth=1.1, zorder=2
    )
    axes.add_patch(patch)
