"""Exact motion of a mechanism with play, stops and dry friction: the flow between events is known in closed form.

All contacts have springs, so the state is continuous: displacements, velocities, and the relaxing springs
behind slots. Each part has a status, such as free or sliding forward; all statuses together are a mode, in
which the motion is linear. ``statuses`` names them, ``machine`` turns a mechanism into arrays, ``assembly``
writes the flow of a mode and the event functions that end it, ``stick`` what sticking frictions hold, and
``series`` their polynomials over a step. ``modes`` keeps those that were met. ``integration`` goes from event
to event, ``step_event`` finds the first one, ``transitions`` says what follows it, and ``instant`` decides
dry friction where several are at rest together. ``variation`` differentiates the motion, ``nodes`` samples
it. ``flow`` is the interface.
"""
