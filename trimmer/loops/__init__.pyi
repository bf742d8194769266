"""The public names of this room, each imported on first use."""

from .components.switched_component import EventKind as EventKind
from .drive import Drive as Drive
from .energy import EnergyBalance as EnergyBalance
from .energy import energy_balance as energy_balance
from .feedback import Feedback as Feedback
from .loop_signal import LoopSignal as LoopSignal
from .loops import ClosedLoop as ClosedLoop
from .loops import OpenLoop as OpenLoop
from .motion import Event as Event
from .motion import LoopMotion as LoopMotion
from .motion import Outcome as Outcome
from .simulation import SimulationInterrupted as SimulationInterrupted
from .trimmer_loop import BodyFriction as BodyFriction
from .trimmer_loop import TrimmerLoop as TrimmerLoop
