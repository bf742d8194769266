"""Elements of the textbooks: saturation, dead zone, relay, preload.

Describing functions over the amplitude. All but the relay with hysteresis have no memory, so their N is
real; hysteresis turns the phase. The loop in the script crosses the real axis at -2, so that N must be 1/2.

    A = 2.475414, omega = 1.000000 rad/s, N = 0.500000
"""

import control
import matplotlib.pyplot as plt
import numpy as np

from trimmer import ClosedLoop, DeadZone, Preload, Relay, Saturation, limit_cycles

elements = {
    "saturation": Saturation(threshold=1.0),
    "dead zone": DeadZone(threshold=1.0),
    "relay": Relay(level=1.0),
    "relay with hysteresis": Relay(level=1.0, hysteresis=0.5),
    "relay with dead zone": Relay(level=1.0, dead_zone=1.0),
    "preload": Preload(level=1.0, slope=0.5),
}

# G = 4 / (s (s + 1)^2) crosses the real axis at omega = 1 with G = -2, so that N = 1/2 there.
loop = ClosedLoop(control.tf([4.0], [1, 2, 1, 0]), elements["saturation"])
(cycle,) = limit_cycles(loop)
gain = elements["saturation"].describing_function(cycle.amplitude).real
print(f"A = {cycle.amplitude:.6f}, omega = {cycle.omega:.6f} rad/s, N = {gain:.6f}")

figure, (sizes, phases) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
amplitudes = np.linspace(0.05, 5, 1000)
for name, element in elements.items():
    values = element.describing_function(amplitudes)
    sizes.plot(amplitudes, np.abs(values))
    phases.plot(amplitudes, np.degrees(np.angle(np.where(values == 0, np.nan, values))), label=name)
sizes.set(xlabel="amplitude", ylabel="|N|", ylim=(0, 3))
phases.set(xlabel="amplitude", ylabel="phase of N, deg")
phases.legend(fontsize="small")
plt.show()
