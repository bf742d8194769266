"""The public names of this room, each imported on first use."""

from .linear.matrices import LinearMatrices as LinearMatrices
from .linear.matrices import linear_matrices as linear_matrices
from .linear.outputs import Contacts as Contacts
from .mechanism import Mechanism as Mechanism
from .parts import GROUND as GROUND
from .parts import Body as Body
from .parts import ContactLaw as ContactLaw
from .parts import Force as Force
from .parts import Friction as Friction
from .parts import Link as Link
from .parts import Output as Output
from .parts import OutputKind as OutputKind
from .parts import Pin as Pin
from .parts import Play as Play
from .parts import Point as Point
from .parts import Stop as Stop
from .parts import Wall as Wall
from .structures.structure import ModalModel as ModalModel
from .structures.structure import Structure as Structure
