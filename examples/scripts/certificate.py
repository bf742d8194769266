"""What a certificate covers.

The colours show |1 + N G| over all amplitudes and frequencies: a limit cycle is where it vanishes. A
grid can pass one by. The solver divides the plane into boxes instead, excludes each by bounds of N and
G, or proves that it holds one solution; a winding number along the border confirms the count.

    complete: True, 8896 boxes, 0 undecided
    winding number 0, sum of the indices 0
"""

import matplotlib.pyplot as plt
import numpy as np

from trimmer import ClosedLoop, FrictionBacklash, TrimmerParameters, harmonic_balance, pin_model, response_at

GAP = 4e-5
system, element = pin_model(TrimmerParameters.thesis()), FrictionBacklash(gap=GAP)
balance = harmonic_balance(ClosedLoop(system, element))
certificate = balance.certificate
print(f"complete: {certificate.complete}, {certificate.boxes} boxes, {len(certificate.undecided)} undecided")
print(f"winding number {certificate.winding_number}, sum of the indices {certificate.index_sum}")

frequencies = np.geomspace(200, 2000, 400)
amplitudes = np.geomspace(1.001, 20, 300) * GAP / 2
gains = element.describing_function(amplitudes)[:, None] * response_at(system, 2 * np.pi * frequencies)
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
shown = axes.pcolormesh(
    frequencies, 1e6 * amplitudes, np.log10(np.abs(1 + gains)), cmap="viridis", rasterized=True
)
for cycle in balance.limit_cycles:
    axes.plot(
        cycle.frequency,
        1e6 * cycle.amplitude,
        "o",
        color="white",
        fillstyle="full" if cycle.stable else "none",
    )
axes.set(xscale="log", yscale="log", xlabel="frequency, Hz", ylabel="amplitude, um")
figure.colorbar(shown, label="log10 |1 + N G|")
plt.show()
