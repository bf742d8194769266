"""Branches of exact periodic orbits over a number of a mechanism, and their special points.

``period_map`` says what a branch is followed of. ``orbit`` solves for one orbit, ``arc`` for orbits on a
short piece of the branch; ``borders`` and ``bifurcations`` find the special points on it. A ``step`` joins
them, ``corner`` turns where the branch does, ``continuation`` strings the steps together, ``switching``
begins the branches that part from one. ``branch`` and ``special`` are the result.
"""
