"""Exact orbits against the prediction.

Harmonic balance takes the motion for a sine. The exact orbit follows the switching from event to event
and closes to rounding. The prediction is 0.6 % off in amplitude here, since the higher harmonics, at the
right, are small.

     174.1 um  728.19 Hz  largest multiplier 0.9663  prediction off by +0.62%
      21.1 um  554.20 Hz  largest multiplier 5.0356  prediction off by +0.03%
"""

import matplotlib.pyplot as plt
import numpy as np

from trimmer import ClosedLoop, FrictionBacklash, TrimmerParameters, periodic_orbits, pin_model

loop = ClosedLoop(pin_model(TrimmerParameters.thesis()), FrictionBacklash(gap=4e-5))
orbits = periodic_orbits(loop)
for orbit in orbits:
    print(
        f"{1e6 * orbit.amplitude:6.1f} um  {orbit.frequency:6.2f} Hz  "
        f"largest multiplier {orbit.largest_multiplier:.4f}  prediction off by {orbit.amplitude_error:+.2%}"
    )

figure, (plane, spectrum) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
for orbit in orbits:
    orbit.plot(plane)
    harmonics = np.abs(orbit.harmonics)
    orders = np.arange(1, len(harmonics) + 1)
    spectrum.semilogy(orders[:15:2], harmonics[:15:2] / harmonics[0], "o-")
spectrum.set(xlabel="harmonic", ylabel="relative to the first")
plt.show()
