"""The public names of this room, each imported on first use."""

from .fit import FitSettings as FitSettings
from .result import Fit as Fit
from .result import FittedNumber as FittedNumber
