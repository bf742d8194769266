"""The bridge in its slot, in both models."""

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.thesis import DRIVE_AMPLITUDE, TURN
from report.numbers.twin.cases import PHASES
from report.pages.drawing.style import FAINT, LINES, panels

THINNED = 16  # Every so many samples are drawn


@figure("twin-bridge-in-slot")
def bridge_in_slot(known: Evidence) -> Figure:
    """Draw the place of the bridge and its force over one period."""
    case = known.twin.experiment
    part = slice(0, PHASES, THINNED)
    phase = np.arange(PHASES)[part] / PHASES
    pin = DRIVE_AMPLITUDE * np.sin(TURN * phase)
    sides, (place, force) = panels(3.1, 1, 2)
    both = {
        "thesis": (case.repeated(case.frozen.bridge), case.repeated(case.frozen.tension)),
        "twin": (case.twin.bridge, case.twin.stretch.tension),
    }
    for (name, (bridge, tension)), line in zip(both.items(), LINES, strict=False):
        place.plot(phase, 1e6 * (bridge[part] - pin), label=name, **line)
        force.plot(phase, tension[part], label=name, **line)
    pulled = case.repeated(case.frozen.pulled.astype(float))[part] > 0
    bottom, top = force.get_ylim()
    force.fill_between(phase, bottom, top, where=pulled, color="#e4e4e4", linewidth=0, zorder=0)
    for side in (-1, 1):
        place.axhline(side * 5e5 * case.twin.gap, **FAINT)
    place.set(xlabel="drive period", ylabel="bridge less pin [µm]", title="place in the slot")
    force.set(xlabel="drive period", ylabel="force on the cutter [N]", title="force of the bridge")
    force.set_ylim(bottom, top)
    place.set_ylim(-140, 140)
    place.legend(loc="upper center", ncols=2)
    return sides
