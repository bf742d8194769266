"""An element of your own, from a function.

A cubic spring that saturates. Its describing function is integrated over a period; up to the kink it is
1 + 3/4 A². The loop oscillates where N = 2. There are no bounds of an element that is known only by its
values, so the certificate is not complete and says so.

    A = 1.1547, omega = 1.0000 rad/s, stable: False
    A = 2.2963, omega = 1.0000 rad/s, stable: True
    complete: False
"""

import control
import matplotlib.pyplot as plt
import numpy as np

from trimmer import ClosedLoop, StaticElement, harmonic_balance


def hardening(x: np.ndarray) -> np.ndarray:
    """Return x + x³, at most 4 in modulus."""
    return np.clip(x + x**3, -4, 4)


spring = StaticElement(hardening, scale=1.0, kinks=(1.3788,))
plant = control.tf([0.1], [1, 0.2, 1, 0])  # crosses the real axis at -1/2
balance = harmonic_balance(ClosedLoop(plant, spring))
for cycle in balance.limit_cycles:
    print(f"A = {cycle.amplitude:.4f}, omega = {cycle.omega:.4f} rad/s, stable: {cycle.stable}")
print(f"complete: {balance.certificate.complete}")

amplitudes = np.linspace(0.01, 4, 200)
figure, (law, gain) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
law.plot(np.linspace(-3, 3, 300), hardening(np.linspace(-3, 3, 300)))
law.set(xlabel="input", ylabel="output")
gain.plot(amplitudes, spring.describing_function(amplitudes).real)
gain.plot(amplitudes[amplitudes < 2], 1 + 0.75 * amplitudes[amplitudes < 2] ** 2, "--")
for cycle in balance.limit_cycles:
    gain.plot(cycle.amplitude, 2.0, "o", color="black", fillstyle="full" if cycle.stable else "none")
gain.set(xlabel="amplitude", ylabel="N", ylim=(0, 3.5))
plt.show()
