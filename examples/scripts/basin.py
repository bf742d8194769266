"""Basins: which start leads where.

At 1.25 Hz the oscillator with a stop has two stable motions, one that hits the stop and one that does
not reach it. The colour says which of them is reached from a displacement and a velocity at the start.

    motion 1: 54% of the starts
    motion 2: 46% of the starts
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import Mechanism, SerialRunner, basin

oscillator = Mechanism.from_toml(Path(__file__).parent.parent / "oscillator-stop.toml").with_value(
    "frequency", 1.25
)
starts = {
    "mass.displacement": np.linspace(-20.0, 20.0, 17),
    "mass.velocity": np.linspace(-200.0, 200.0, 15),
}
reached = basin(oscillator, starts, runner=SerialRunner(), quiet=True)
for number, share in enumerate(reached.shares, start=1):
    print(f"motion {number}: {share:.0%} of the starts")
reached.plot()
plt.show()
