"""Den Hartog's oscillator.

Mass, spring and dry friction under a cosine force. Den Hartog solved it in 1931 for motion without
stops; the points are his formula, the lines exact orbits followed over the frequency. Where friction
stops the mass, his formula ends and the orbits go on. At 0.5 his formula does not hold, and branches meet.

    friction 0.2: at 0.7 the two differ by less than 0.001: True
    friction 0.4: at 0.7 the two differ by less than 0.001: True
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from trimmer import Mechanism, follow

oscillator = Mechanism.from_toml(Path(__file__).parent.parent / "den-hartog.toml")


def den_hartog(ratio: np.ndarray, friction: float) -> np.ndarray:
    """Return his amplitude for a mass, a spring and a force of 1."""
    angle = np.pi / ratio
    stick = np.sin(angle) / (ratio * (1 + np.cos(angle)))
    return np.sqrt(1 / (1 - ratio**2) ** 2 - (friction * stick) ** 2)


figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for friction, colour in ((0.2, "C0"), (0.4, "C1")):
    rubbing = oscillator.with_value("frictions.floor.force", friction)
    branch = follow(rubbing, "frequency", 0.55 / (2 * np.pi), 0.9 / (2 * np.pi))
    ratios = np.array([2 * np.pi * point.value for point in branch.points])
    sizes = np.array([point.outputs["block"].peak_to_peak / 2 for point in branch.points])
    axes.plot(ratios, sizes, color=colour, label=f"friction {friction}")
    few = np.linspace(0.6, 0.9, 7)
    axes.plot(few, den_hartog(few, friction), "o", color=colour, fillstyle="none")
    difference = np.interp(0.7, ratios, sizes) - den_hartog(np.array(0.7), friction)
    print(f"friction {friction}: at 0.7 the two differ by less than 0.001: {abs(difference) < 1e-3}")
axes.set(xlabel="frequency ratio", ylabel="amplitude / static deflection")
axes.legend()
plt.show()
