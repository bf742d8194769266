"""A measured vibration, and what its lines are.

A record of a driven trimmer, here simulated and written as a CSV file; yours would come from a recorder.
Each peak of the spectrum is held against what is known: harmonics of the drive, natural modes, a limit
cycle.

      110.0 Hz    1508.9 um
      550.0 Hz      79.0 um
      330.0 Hz      22.7 um
      770.0 Hz       2.8 um
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import (
    Drive,
    FrictionBacklash,
    Signal,
    TrimmerLoop,
    TrimmerParameters,
    analyse_signal,
    read_signal,
    simulate,
    write_signal,
)

RATE = 10_000.0
loop = TrimmerLoop(
    TrimmerParameters.thesis(), FrictionBacklash(gap=4e-5), drive=Drive(1.5e-3, frequency=110.0)
)
motion = simulate(loop, duration=1.0)
times = np.arange(int(RATE * motion.duration)) / RATE
with tempfile.TemporaryDirectory() as folder:
    file = Path(folder) / "vibration.csv"
    write_signal(file, Signal(motion.output(times), RATE, "stroke", "m"))
    signal = read_signal(file, column="stroke")

analysis = analyse_signal(signal, drive_frequency=110.0)
for classified in analysis.peaks[:4]:
    print(f"{classified.peak.frequency:7.1f} Hz  {1e6 * classified.peak.amplitude:8.1f} um")
analysis.plot()
plt.show()
