"""Statuses of contacts and frictions, and what an event function that falls to zero means."""

from trimmer.hybrid.system import OWN_ACTIONS, OWN_KINDS

FREE, RELAXING, PLUS, MINUS, RELEASED_PLUS, RELEASED_MINUS, ALWAYS = range(7)
"""A contact: without force and relaxed; without force, its spring relaxing; in contact where the end is far
from the start, or on the other side; beyond the gap without force; a play without gap, always in contact."""
LOOSE, RESTS = range(2)  # A wall: its ends are apart, or rest on each other
FORWARD, BACKWARD, STICK = range(3)
"""A friction: its end slides forward relative to its start, slides backward, or sticks."""

RELAXES, TRUNCATES, PULLS = range(3)
"""The contact laws. Without damping they are one, which is held as the last."""

WITHIN, AT_UPPER, AT_LOWER = range(3)
"""A controller: what it demands is within its limits; the upper or the lower one acts."""

ACTIONS = OWN_ACTIONS + 9  # Number of actions of event functions
MADE_PLUS, MADE_MINUS, BROKEN, RETURNED, LEFT, ABOVE_KNOT, BELOW_KNOT, ABOVE_LIMIT, BELOW_LIMIT = range(
    OWN_ACTIONS, ACTIONS
)
"""Event functions of contacts: contact made on either side, broken; the force of a contact that was released
is a push again, or it left the range of contact. Of curves: a knot is reached from below, from above. Of
controllers: the same of a limit."""
KIND_COUNT = OWN_KINDS + 5  # Number of kinds of events
CONTACT_MADE, CONTACT_BROKEN, IMPACT, COMPLETED, TOGETHER = range(OWN_KINDS, KIND_COUNT)
"""What contacts and walls do that begins a segment of the motion; of walls an impact with its restitution,
the impulse that ends an infinite chatter, and that of walls which act together without rebound."""
IMPULSES = (IMPACT, COMPLETED, TOGETHER)  # Kinds of events with an impulse
