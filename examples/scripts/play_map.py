"""A map of the trimmer: what play and friction do.

Each cell starts at rest and is followed until it has settled. Coarse here, so that it takes seconds;
`trimmer map` draws it as finely as you like, on all cores, and goes on where it was interrupted.

    up to 100 um all repeat after each drive period, from 0.5 to 2.5 N
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import Mechanism, SerialRunner, motion_map

trimmer = Mechanism.from_toml(Path(__file__).parent.parent / "thesis-play.toml")
values = {
    "plays.bridge.gap": np.linspace(0, 200e-6, 9),
    "frictions.blade.force": np.linspace(0.5, 2.5, 5),
}
motions = motion_map(trimmer, values, runner=SerialRunner(), quiet=True)
gaps, forces = motions.values
repeats = np.all(motions.period_count == 1, axis=0)
largest = gaps[np.flatnonzero(~repeats)[0] - 1]
print(f"up to {1e6 * largest:.0f} um all repeat after each drive period, from {forces[0]} to {forces[-1]} N")
motions.plot()
plt.show()
