"""What a mechanism or a loop settles to: exact periodic motions, and statistics of what does not repeat.

``periodic`` solves for a state that returns, ``exact_orbit`` begins that; ``by_itself`` is all this without
a drive, where the period is unknown. ``respond`` follows a motion from its start: ``settling`` looks for
orbits on the way, and says what it is that does not settle. What meets no event any more is known for all
time (``without_events``), what does not repeat through its ``statistics``; ``results`` is what is found.

``flows`` gives the motion of either, from which all here is asked, ``starts`` reads where it begins.
``simulation`` is plain simulation, ``step`` the response of a controlled mechanism to a step.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
