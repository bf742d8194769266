"""Several dry frictions and relays at once: what holds, what begins to slide, and what is at rest.

``dry_friction`` is the contact problem; ``coupled_relays`` applies it to modes, and ``complementarity`` to
instants. ``stick`` moves a state to where what is held is zero to the last digit.
"""
