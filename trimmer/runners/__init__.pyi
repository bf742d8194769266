"""The public names of this room, each imported on first use."""

from .cluster import ClusterRunner as ClusterRunner
from .processes import ProcessRunner as ProcessRunner
from .runner import Runner as Runner
from .runner import SerialRunner as SerialRunner
