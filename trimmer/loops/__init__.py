"""Exact motion of a linear system with switched elements: the flow between events is known in closed form.

``simulation`` is the entry, ``loops`` and ``trimmer_loop`` say what moves, ``motion`` holds the result
and ``energy`` balances it. In ``components`` is what elements are in time, in ``frictions`` what several
frictions do at once. ``interconnection`` joins components and plant, ``mode`` gives the flow of a
combination of modes, for which ``implicit_outputs`` finds what follows from conditions; ``system`` is the
loop as the core of ``trimmer.hybrid`` asks for it, ``integration`` asks that core for a motion,
``initial`` gives the state at the start. ``flow`` is the loop as settling, orbits, branches and maps ask
for it, with ``readouts`` of its parts; ``numbers`` are its places.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
