"""Elements in time: each made of components that switch.

``switched_component`` is their interface, which the others implement; ``of_elements`` chooses among them.
"""
