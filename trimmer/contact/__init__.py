"""A mechanism with play, stops and dry friction as the core of exact motion asks for it.

All contacts have springs, so the state is continuous: displacements, velocities, and the relaxing springs
behind slots. Each part has a status, such as free or sliding forward; all statuses together are a mode.
``flow`` is the interface.

``state`` names the entries of the state, in a frame; ``machine`` turns a mechanism into arrays and names the
statuses and events. ``modes`` writes the equations of a mode and the event functions that end it, says what
follows them, decides where several frictions are at rest together, and puts all of this together for
``trimmer.hybrid``; ``readouts`` reads the motion that comes of it. Imports go that way only.
"""
