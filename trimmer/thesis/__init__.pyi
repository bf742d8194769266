"""The public names of this room, each imported on first use."""

from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD as CUTTER_RELATIVE_TO_GUARD
from trimmer.displacement import Displacement as Displacement
from trimmer.displacement import DisplacementError as DisplacementError
from trimmer.displacement import TrimmerBody as TrimmerBody
from trimmer.linear.model import InputChannels as InputChannels
from trimmer.linear.model import linear_model as linear_model
from trimmer.linear.model import pin_model as pin_model
from trimmer.linear.model import transfer_function as transfer_function
from trimmer.loops.trimmer_loop import BodyFriction as BodyFriction
from trimmer.loops.trimmer_loop import TrimmerLoop as TrimmerLoop
from trimmer.parameters import ParameterError as ParameterError
from trimmer.parameters import TrimmerParameters as TrimmerParameters
from trimmer.parameters import parameter_table as parameter_table
