"""A branch with folds and period doublings.

An oscillator that meets a stop. The branch of its periodic motions is followed over the drive's
frequency, through two folds; between them two stable motions exist. On the way the period doubles and
comes back. Solid lines are stable.

    grazing          at 0.880871 Hz
    period-doubling  at 0.884379 Hz
    period-doubling  at 0.908442 Hz
    fold             at 1.363384 Hz
    fold             at 1.113707 Hz
    grazing          at 1.113713 Hz
"""

from pathlib import Path

import matplotlib.pyplot as plt

from trimmer import Mechanism, follow

oscillator = Mechanism.from_toml(Path(__file__).parent.parent / "oscillator-stop.toml")
branch = follow(oscillator, "frequency", 0.85, 1.45)
for special in branch.special:
    print(f"{special.kind.word:16} at {special.value:.6f} Hz")
branch.plot()
plt.show()
