"""A mechanism as data: bodies, and what holds, pushes and rubs them.

``parts`` are the parts, ``mechanism`` puts them together, ``reading`` and ``writing`` are its TOML file.
The parts are public here, since ``trimmer.Body`` is a body of the thesis's trimmer:

    >>> from trimmer.mechanism import Body, Link, Mechanism
    >>> oscillator = Mechanism({"mass": Body(1.0)}, links={"spring": Link(("ground", "mass"), stiffness=1.0)})
"""

from trimmer.mechanism.mechanism import Mechanism as Mechanism
from trimmer.mechanism.parts import GROUND as GROUND
from trimmer.mechanism.parts import Body as Body
from trimmer.mechanism.parts import ContactLaw as ContactLaw
from trimmer.mechanism.parts import Force as Force
from trimmer.mechanism.parts import Friction as Friction
from trimmer.mechanism.parts import Link as Link
from trimmer.mechanism.parts import Output as Output
from trimmer.mechanism.parts import Pin as Pin
from trimmer.mechanism.parts import Play as Play
from trimmer.mechanism.parts import Stop as Stop
