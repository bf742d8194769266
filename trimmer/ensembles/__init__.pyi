"""The public names of this room, each imported on first use."""

from .limit_cycles import SampledLimitCycles as SampledLimitCycles
from .limit_cycles import sampled_limit_cycles as sampled_limit_cycles
