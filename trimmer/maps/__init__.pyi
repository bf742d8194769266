"""The public names of this room, each imported on first use."""

from .basin import Basin as Basin
from .coexistence import Coexistence as Coexistence
from .coexistence import coexisting_motions as coexisting_motions
from .result import MotionMap as MotionMap
from .run_up import sweep as sweep
from .special_curve import SpecialCurve as SpecialCurve
from .special_curve import SpecialCurves as SpecialCurves
from .swept import Sweep as Sweep
