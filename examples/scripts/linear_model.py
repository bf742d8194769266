"""The linear trimmer: resonances from the pin to the stroke.

The transfer function from the displacement and velocity of the pin to that of the cutter relative to the
guard. Each peak belongs to a mode; the drive at 110 Hz stands well below the first.

      222.3 Hz, damping ratio 0.0179
      354.8 Hz, damping ratio 0.0188
      549.6 Hz, damping ratio 0.0233
     1139.5 Hz, damping ratio 0.0754
"""

import matplotlib.pyplot as plt

from trimmer import TrimmerParameters, modes, summarise

parameters = TrimmerParameters.thesis()
for mode in modes(parameters):
    print(f"{mode.frequency:7.1f} Hz, damping ratio {mode.damping_ratio:.4f}")

axes = summarise(parameters).plot()
axes.axvline(110.0, color="0.6", linestyle=":")
plt.show()
