"""The lines of a motion on a torus: sums of multiples of the drive and of a frequency of its own."""

from collections.abc import Sequence

MOST_OWN = 6  # Multiple of the motion's own frequency up to which a line is named
OFF = 0.1
"""Distance from a sum at which a line is named by it, in bins, for each of its frequencies that it takes."""

Line = tuple[float, float]


def sums_of(
    lines: Sequence[Line], drive: float, resolution: float
) -> tuple[float | None, tuple[tuple[int, int] | None, ...]]:
    """Name lines as sums of multiples of the drive and of one further frequency.

    Args:
        lines: Frequency, Hz, and amplitude of each.
        drive: Frequency of the drive, Hz.
        resolution: Width of a bin of the record, Hz.

    Returns:
        That further frequency, of the largest line that is no multiple of the drive, and of each line the
        multiples i and j of the two of which it is the sum; None where all are multiples of the drive, and
        for a line that is no sum.
    """
    apart = [each for each in lines if _sum(each[0], drive, 0.0, 0, resolution) is None]
    own = max(apart, key=lambda each: each[1])[0] if apart else None
    return own, tuple(_named(frequency, drive, own or 0.0, resolution) for frequency, _ in lines)


def _named(frequency: float, drive: float, own: float, resolution: float) -> tuple[int, int] | None:
    """Return the sum with the least of the motion's own frequency."""
    return next(
        (
            name
            for j in sorted(range(MOST_OWN, -MOST_OWN - 1, -1), key=abs)
            if (name := _sum(frequency, drive, own, j, resolution)) is not None
        ),
        None,
    )


def _sum(frequency: float, drive: float, own: float, j: int, resolution: float) -> tuple[int, int] | None:
    i = round((frequency - j * own) / drive)
    off = abs(frequency - i * drive - j * own)
    return (i, j) if off <= OFF * (1 + abs(j)) * resolution else None
