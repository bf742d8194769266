"""What moves without a drive: nothing counts periods, and what it comes to has a period that is unknown.

``self_excited`` follows it: to rest, also by slips that shrink for ever (``asymptotic``) or ever slower
(``dying_away``); to an orbit, from ``recurrences`` of a state, with ``arrival`` at it;
or on, as its ``returns`` tell chaos and ``unrepeated`` puts in words. ``orbit_by_itself`` is the orbit alone.
"""
