"""Gain of the loop of figure 2.5 where a plant that leads undoes the lag of backlash."""

from __future__ import annotations

import control
import numpy as np

from trimmer import response_at

OMEGAS = np.linspace(1.0, 2e4, 20_001)
"""Angular frequencies at which the phase is looked at, rad/s: far beyond the last natural mode."""
AMPLITUDES = np.geomspace(0.5001, 1e7, 4_000)
"""Amplitudes over the gap, from the edge of the dead band to where the gap no longer matters."""


def gains_where_phases_match(system: control.StateSpace | control.TransferFunction) -> tuple[float, float]:
    """Return the least and the largest |N G| over all frequencies where G leads by what backlash lags."""
    library = control.friction_backlash_nonlinearity(1.0)
    lag = np.array([-np.angle(library.describing_function(float(each))) for each in AMPLITUDES])
    response = np.asarray(response_at(system, OMEGAS))
    response = response[np.angle(response) > 0]
    matching = np.interp(np.angle(response), lag[::-1], AMPLITUDES[::-1])
    gains = [
        abs(value * library.describing_function(float(amplitude)))
        for value, amplitude in zip(response, matching, strict=True)
    ]
    return float(min(gains)), float(max(gains))
