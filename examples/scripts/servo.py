"""A servo with backlash.

A motor moves a carriage through a gear with 0.2 mm of play. Where the carriage turns, it rests on its
guide while the gear crosses the play, and the error grows. Below, when the teeth touch and when
something sticks.

    play 0.0 mm: error 0.951 mm from peak to peak
    play 0.1 mm: error 1.035 mm from peak to peak
    play 0.2 mm: error 1.136 mm from peak to peak
    play 0.4 mm: error 1.348 mm from peak to peak
"""

from pathlib import Path

import matplotlib.pyplot as plt

from trimmer import Mechanism, respond

servo = Mechanism.from_toml(Path(__file__).parent.parent / "servo.toml")
for gap in (0.0, 0.1e-3, 0.2e-3, 0.4e-3):
    response = respond(servo.with_value("plays.gear.gap", gap))
    error = response.motion.peak_to_peak["error"]
    print(f"play {1e3 * gap:.1f} mm: error {1e3 * error:.3f} mm from peak to peak")

respond(servo).plot()
plt.show()
