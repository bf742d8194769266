"""A mechanism with play, stops and dry friction as the core of exact motion asks for it.

All contacts have springs, so the state is continuous: displacements, velocities, and the relaxing springs
behind slots. Each part has a status, such as free or sliding forward; all statuses together are a mode.
``flow`` is the interface.

``statuses`` names the statuses and events, ``layout`` the entries of the state, in a ``frame``; ``machine``
turns a mechanism into arrays. ``assembly`` writes the equations of a mode and the event functions that end
it, ``transitions`` says what follows them, and ``joint`` decides where several frictions are at rest
together. ``system`` puts them together for ``trimmer.hybrid``.
"""
