"""Loops that the tests share."""

import control

from trimmer import FrictionBacklash, TrimmerParameters, pin_model
from trimmer.linear import InputChannels

GAP = 4e-5
FRICTION = FrictionBacklash(GAP)
THESIS_LOOP = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
LOOP_WITH_BOTH_CHANNELS = pin_model(TrimmerParameters.thesis())

s = control.tf("s")
THIRD_ORDER = 1 / (s * (s + 1) * (s + 2))
