"""What a branch is followed of: maps of a state to the state a period later, over one number.

``driven_map`` is the map of what has a drive, ``driven_passage`` the motion that it follows. ``value_rate``
differentiates that by the number, between events by ``value_flow``; ``curved`` knows how equations change
that are polynomials of it. ``self_excited_map`` is the map of what moves by itself, with an unknown period.
``fitting`` chooses the map of a motion, and whether half a period will do.
"""
