"""The public names of this room, each imported on first use."""

from .feasible_frequencies import BandEnd as BandEnd
from .feasible_frequencies import FeasibleBand as FeasibleBand
from .identification import Identification as Identification
from .identification import IdentifiedTimeConstant as IdentifiedTimeConstant
from .identification import TimeConstantInterval as TimeConstantInterval
from .identification import identify_time_constant as identify_time_constant
from .leakage import harmonic_leakage as harmonic_leakage
from .limit_cycle import Certificate as Certificate
from .limit_cycle import HarmonicBalance as HarmonicBalance
from .limit_cycle import LimitCycle as LimitCycle
from .limit_cycle import UndecidedRegion as UndecidedRegion
from .many_harmonics.feedback import BalancedMotion as BalancedMotion
from .many_harmonics.feedback import FeedbackBalance as FeedbackBalance
from .solve import harmonic_balance as harmonic_balance
from .solve import limit_cycles as limit_cycles
