"""The public names of this room, each imported on first use."""

from .energy import MechanismEnergy as MechanismEnergy
from .motion import MechanismMotion as MechanismMotion
from .orbit import MechanismOrbit as MechanismOrbit
from .response import MotionKind as MotionKind
from .response import Response as Response
from .step import StepResponse as StepResponse
from .step import step_response as step_response
