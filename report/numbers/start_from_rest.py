"""The linear trimmer after a start from rest (figure 5.1)."""

from __future__ import annotations

import numpy as np

from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA
from trimmer import InputChannels, TrimmerParameters, pin_model, time_response
from trimmer.arrays import Reals


def pin_and_output(parameters: TrimmerParameters, times: Reals) -> tuple[Reals, Reals]:
    """Return the pin's displacement and the output of the thesis's model, m, at equally spaced times, s."""
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * times)
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    return pin, time_response(system, times, pin).outputs
