"""Describing functions of three backlashes.

What passes a play depends on the load behind it. A load with friction stays where it was left; one with
inertia flies on until it is hit; a viscous one lies between the two. Magnitude and phase of N over the
amplitude, in units of half the gap, at the drive's frequency.

    friction             N at twice half the gap: 0.5927, -32.5 deg
    viscous, M/D = 1 ms  N at twice half the gap: 0.7202, -35.1 deg
    inertia              N at twice half the gap: 1.2327, -28.3 deg
"""

import matplotlib.pyplot as plt
import numpy as np

from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash

GAP = 4e-5
OMEGA = 2 * np.pi * 110.0
backlashes = {
    "friction": FrictionBacklash(gap=GAP),
    "viscous, M/D = 1 ms": ViscousBacklash(gap=GAP, time_constant=1e-3),
    "inertia": InertiaBacklash(gap=GAP),
}

figure, (sizes, phases) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
ratios = np.linspace(1.001, 6, 500)
for name, backlash in backlashes.items():
    values = backlash.describing_function(ratios * GAP / 2, OMEGA)
    sizes.plot(ratios, np.abs(values), label=name)
    phases.plot(ratios, np.degrees(np.angle(values)))
    value = backlash.describing_function(GAP, OMEGA)
    print(f"{name:20} N at twice half the gap: {abs(value):.4f}, {np.degrees(np.angle(value)):+.1f} deg")
sizes.set(xlabel="amplitude / half of the gap", ylabel="|N|")
phases.set(xlabel="amplitude / half of the gap", ylabel="phase of N, deg")
sizes.legend()
plt.show()
