"""What a branch is followed of: maps of a state to the state a period later, over one number.

``period_map`` says what such a map must give. ``driven_map`` is that of what has a drive, and ``value_rate``
differentiates it by the number, between events by ``value_flow``; ``curved`` knows how equations change that
are polynomials of it. ``self_excited_map`` is the map of what moves by itself, with an unknown period. A
``doubled_map`` joins two passages to one. ``fitting`` chooses the map of a motion, and whether half a period
will do.
"""
