"""Limit cycles of a loop with play, in the Nyquist plane.

Where the curve of G meets that of -1/N, harmonic balance predicts a limit cycle: full where it is
stable, open where not. Beside each prediction stands how much of the third harmonic comes back, which it
neglects.

      21.1 um  554.29 Hz  unstable  third harmonic 0.22%
     175.2 um  728.40 Hz  stable    third harmonic 0.25%
"""

import matplotlib.pyplot as plt

from trimmer import (
    ClosedLoop,
    FrictionBacklash,
    TrimmerParameters,
    harmonic_balance,
    harmonic_leakage,
    pin_model,
)

loop = ClosedLoop(pin_model(TrimmerParameters.thesis()), FrictionBacklash(gap=4e-5))
balance = harmonic_balance(loop)
for cycle in balance.limit_cycles:
    third = harmonic_leakage(loop, cycle)[0]
    print(
        f"{1e6 * cycle.amplitude:6.1f} um  {cycle.frequency:6.2f} Hz  "
        f"{'stable' if cycle.stable else 'unstable':8}  third harmonic {third:.2%}"
    )
balance.plot()
plt.show()
