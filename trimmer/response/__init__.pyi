"""The public names of this room, each imported on first use."""

from .periodic.orbit import MechanismOrbit as MechanismOrbit
from .results.response import MotionKind as MotionKind
from .results.response import Response as Response
from .simulation.energy import MechanismEnergy as MechanismEnergy
from .simulation.motion import MechanismMotion as MechanismMotion
from .step.step import StepResponse as StepResponse
from .step.step import step_response as step_response
