"""Several dry frictions and relays at once: what holds, what begins to slide, and what is at rest.

``coupled_relays`` applies ``trimmer.hybrid.dry_friction`` to modes, and ``complementarity`` to instants.
``stick`` moves a state to where what is held is zero to the last digit.
"""
