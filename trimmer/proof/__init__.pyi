"""The public names of this room, each imported on first use."""

from .outcome import Verdict as Verdict
from .proof import Proof as Proof
from .proof import ProofFileError as ProofFileError
from .proof import check_proof as check_proof
from .prove import prove_limit_cycles as prove_limit_cycles
from .prove import prove_motion as prove_motion
from .prove import prove_orbit as prove_orbit
from .prove import prove_special_point as prove_special_point
