"""The times at which something is on in a motion, such as contact or stick."""

import numpy as np

from trimmer.arrays import Flags, Reals


def spans_of(starts: Reals, duration: float, on: Flags) -> list[tuple[float, float]]:
    """Return start and length, s, of each time at which it is on in segments, (n,); what touches is one."""
    lengths = np.diff(np.append(starts, duration))
    spans: list[tuple[float, float]] = []
    for start, length, each in zip(starts.tolist(), lengths.tolist(), on, strict=True):
        if not each or length <= 0:
            continue
        if spans and np.isclose(sum(spans[-1]), start, rtol=0, atol=1e-12 * duration):
            spans[-1] = spans[-1][0], start + length - spans[-1][0]
        else:
            spans.append((start, length))
    return spans
