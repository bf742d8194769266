"""python-control's describing functions: harmonic balance of the relay loop."""

import math

import control
import numpy as np

from benchmarks.peers.telling import tell

SETTINGS = {"20 amplitudes, 500 frequencies": 500, "20 amplitudes, 5000 frequencies": 5000}
PLANT = control.tf([4.0], [1.0, 3.0, 3.0, 1.0])


def cycle(frequencies: int) -> tuple[float, float]:
    """Return amplitude and omega of the only intersection."""
    relay = control.relay_hysteresis_nonlinearity(1.0, 0.0)
    response = control.describing_function_response(
        PLANT, relay, np.linspace(0.01, 2.0, 20), np.logspace(-1, 1, frequencies)
    )
    ((amplitude, omega),) = response.intersections
    return amplitude, omega


if __name__ == "__main__":
    name = f"python-control {control.__version__}"
    for setting, number in SETTINGS.items():
        tell(name, setting, "relay-loop", "predicted amplitude", lambda n=number: cycle(n)[0])
        tell(name, setting, "relay-loop", "predicted period", lambda n=number: 2 * math.pi / cycle(n)[1])
