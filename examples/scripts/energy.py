"""Where the energy goes.

What the pin puts into the trimmer is lost in dampers, in contacts and in friction. The balance closes to
rounding, which is a check of the simulation as well. The friction of the blade takes more than nine
tenths, with any play.

      0 um: 93.1% goes into the blade
     40 um: 94.1% goes into the blade
    100 um: 92.6% goes into the blade
    200 um: 95.5% goes into the blade
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import Mechanism, simulate

trimmer = Mechanism.from_toml(Path(__file__).parent.parent / "thesis-play.toml")
gaps = (0.0, 40e-6, 100e-6, 200e-6)
names, shares = [], []
for gap in gaps:
    energy = simulate(trimmer.with_value("plays.bridge.gap", gap), 0.1).energy
    lost = {**energy.dampers, **energy.contacts, **energy.frictions}
    names, shares = list(lost), [*shares, [value / sum(lost.values()) for value in lost.values()]]
    print(f"{1e6 * gap:3.0f} um: {energy.frictions['blade'] / sum(lost.values()):.1%} goes into the blade")

figure, axes = plt.subplots(figsize=(7, 3.4), layout="constrained")
left = np.zeros(len(gaps))
for name, widths in zip(names, np.array(shares).T, strict=True):
    axes.barh([f"{1e6 * gap:.0f} um" for gap in gaps], widths, left=left, label=name)
    left += widths
axes.set(xlabel="share of what is lost", ylabel="play")
figure.legend(loc="outside right upper")
plt.show()
