"""Axes in a unit in which their numbers are easy to read, such as µm or ms."""

from matplotlib.axis import Axis
from matplotlib.ticker import FuncFormatter

PREFIXES = ((1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
PREFIXED = (
    *("m", "s", "N", "Hz", "m/s", "m/s²", "N/m", "N s/m", "W", "J"),
    *("rad", "rad/s", "rad/s²", "N m", "N m/rad", "N m s/rad"),
)
"""Units that take a prefix."""
FITS = 0.8  # A prefix fits if the largest number of the axis is at least so many of it


def name_axis(axis: Axis, name: str, unit: str) -> None:
    """Write name and SI unit at an axis whose data are drawn already, with one prefix for all its numbers."""
    factor, prefix = prefix_for(max(abs(float(end)) for end in axis.get_view_interval()), unit)
    axis.set_major_formatter(
        FuncFormatter(lambda value, _: f"{value / factor:.6g}".replace("-", "\N{MINUS SIGN}"))
    )
    axis.set_label_text(f"{name}, {prefix}{unit}" if unit else name, parse_math=False)


def with_prefix(value: float, unit: str) -> str:
    """Write a value with its unit, with the prefix that suits it."""
    factor, prefix = prefix_for(abs(value), unit)
    return f"{value / factor:.4g} {prefix}{unit}".rstrip()


def prefix_for(largest: float, unit: str) -> tuple[float, str]:
    """Return the factor and the prefix of a unit that suit the largest of some numbers."""
    if unit not in PREFIXED or not largest > 0:
        return 1.0, ""
    fitting = [each for each in PREFIXES if largest >= FITS * each[0]]
    return fitting[0] if fitting else PREFIXES[-1]
