"""Branches of exact periodic orbits over a number of a mechanism, and their special points.

``follow`` is the entry, and ``followed`` its result. ``mechanism_map`` maps a state to that a period later,
and ``value_rate`` differentiates it by the number; ``self_excited_map`` does so with an unknown period, for
what moves by itself. ``fitting`` chooses the map of a motion, and whether half a period will do; ``outputs``
says what the orbits look like.

The rest knows nothing of mechanisms: ``period_map`` says what a branch is followed of. ``orbit`` solves
for one orbit, ``arc`` for orbits on a short piece of the branch; ``borders``, by ``narrowing``, and
``bifurcations`` find the special points on it. A ``step`` joins them, ``corner`` turns where the branch
does, ``stepping`` says how long each step is, ``continuation`` strings branches together, ``switching``
begins those that part from one, on a ``doubled_map`` or its like, and ``joining`` goes the other way, from
doubled orbits to single ones and from asymmetric to symmetric ones; ``known`` says what has been followed
already. ``branch`` and ``special`` are the result.

``follow_special`` follows a special point over two numbers: ``relocation`` finds it again on a short piece of
branch, and ``locus`` is the result.
"""
