"""Stick and slip without a drive.

A block on a belt, held by a spring. It is carried along until the spring overcomes the static friction,
slips back, and is caught again. The period is an unknown of the orbit and is solved for with it.

    period 8.902605 s, in stick for 56.16% of it, stable: True
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import Mechanism, forced_orbit, simulate

belt = Mechanism.from_toml(Path(__file__).parent.parent / "block-on-belt.toml")
orbit = forced_orbit(belt)
stick = orbit.measures.frictions["rubbing"].stick
print(f"period {orbit.period:.6f} s, in stick for {stick:.2%} of it, stable: {orbit.stable}")

motion = simulate(belt, 40.0)
times = np.linspace(0, motion.duration, 2000)
figure, (over_time, plane) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
over_time.plot(times, motion.displacement("block", times))
over_time.set(xlabel="time, s", ylabel="displacement, m")
orbit.plot(plane)
plt.show()
