"""Samples of the thesis's loop as text and as JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.mechanisms.sample_text import (
    distribution_data,
    distribution_lines,
    index_data,
    index_lines,
    share_data,
    share_text,
)
from trimmer.uncertainty.statistics import distribution_of, share_of

if TYPE_CHECKING:
    from trimmer.uncertainty.limit_cycle_samples import LimitCycleSamples


def as_text(samples: LimitCycleSamples) -> str:
    """Return what samples of a loop tell, for people."""
    found, total = samples.found, len(samples.found.count)
    stable = share_of(int(found.exists.sum()), total)
    lines = [f"a stable limit cycle is predicted for {share_text(stable)}", "", "limit cycles"]
    for count in np.unique(found.count).tolist():
        lines.append(f"  {count}  {share_text(share_of(int((found.count == count).sum()), total))}")
    lines += ["", "the largest stable one (in brackets: 95 % interval of a quantile)"]
    amplitude, frequency = samples.largest
    lines += distribution_lines([("amplitude", amplitude, "m"), ("frequency", frequency, "Hz")])
    lines += index_lines(samples.indices)
    return "\n".join([*lines, "", samples.message, f"{samples.per_second:.3g} samples per second."])


def as_json(samples: LimitCycleSamples) -> str:
    """Return what samples of a loop tell, for programs; see docs/json.md."""
    found, total = samples.found, len(samples.found.count)
    amplitude, frequency = samples.largest
    data = {
        "count": len(samples.values),
        "impossible": int((~samples.possible).sum()),
        **picked(samples.settings, "plan", "seed"),
        "scatters": [picked(each, "place", "unit") for each in samples.file.uncertainty.scatters],
        "stable": share_data(share_of(int(found.exists.sum()), total)),
        "limit_cycles": {
            str(count): share_data(share_of(int((found.count == count).sum()), total))
            for count in np.unique(found.count).tolist()
        },
        "amplitude": distribution_data(distribution_of(amplitude)),
        "frequency": distribution_data(distribution_of(frequency)),
        "searched_again": int(found.searched_again.sum()),
        "undecided": int(found.undecided.sum()),
        "indices": index_data(samples.indices),
        "message": samples.message,
    }
    return document(data)
