"""Exact motion of a mechanism with play, stops and dry friction.

All contacts have springs, so the state is continuous: displacements, velocities, and the relaxing springs
behind slots. Each part has a status, such as free or sliding forward; all statuses together are a mode, in
which the motion is linear and its flow known in closed form. ``flow`` is the interface.

``statuses`` names the statuses and events, ``layout`` the entries of the state; ``machine`` turns a mechanism
into arrays. ``assembly`` writes the equations of a mode and the event functions that end it, ``transitions``
says what follows them, and ``joint`` decides where several frictions are at rest together. ``tables`` keeps
the modes that were met, and ``series`` writes their polynomials. ``integration`` goes from event to event in
compiled code, ``step_event`` finds the next one, ``work`` holds its arrays, and ``advance`` calls it.
``variation`` differentiates the motion, and ``nodes`` samples it.
"""
