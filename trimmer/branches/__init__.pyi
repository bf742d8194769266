"""The public names of this room, each imported on first use."""

from .balanced import BalancedOrbit as BalancedOrbit
from .branch import BranchEnd as BranchEnd
from .followed import FollowedBranch as FollowedBranch
from .followed import FollowedOrbit as FollowedOrbit
from .loci.follow_special import follow_special as follow_special
from .loci.locus import Locus as Locus
from .loci.locus import LocusEnd as LocusEnd
from .loci.locus import LocusRanges as LocusRanges
from .loci.locus import LocusSettings as LocusSettings
from .outputs import OutputMeasure as OutputMeasure
from .settings import FollowSettings as FollowSettings
from .special import SpecialKind as SpecialKind
from .special import SpecialPoint as SpecialPoint
