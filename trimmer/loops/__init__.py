"""Exact motion of a linear system with switched elements: the flow between events is known in closed form.

``simulation`` is the entry, ``loops`` and ``trimmer_loop`` say what moves, ``motion`` holds the result and
``energy`` balances it. ``switched_component`` is the interface of an element in time, implemented by
``backlash_component``, ``relay_component`` and ``linear_components``; ``components_of_elements`` chooses
among them. ``interconnection`` joins components and plant, ``mode`` gives the flow of a combination of modes,
for which ``implicit_outputs`` finds what follows from conditions; ``system`` is the loop as the core of
``trimmer.hybrid`` asks for it, ``integration`` asks that core for a motion, ``initial`` gives the state at
the start. In ``frictions`` is what several frictions do at once. ``flow`` is the loop as settling, orbits,
branches and maps ask for it, with ``readouts`` of its parts; ``numbers`` are its places.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
