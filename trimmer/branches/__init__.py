"""Branches of exact periodic orbits over a number of a mechanism, and their special points.

``follow`` is the entry, and ``followed`` its result; ``outputs`` says what the orbits look like. The maps
whose fixed points they are stand in ``period_maps``, some of which know mechanisms.

The rest knows nothing of mechanisms. ``orbit`` solves for one orbit, ``arc`` for orbits on a short piece of
the branch; ``borders``, by ``narrowing``, and ``bifurcations`` find the special points on it. A ``step``
joins them, ``corner`` turns where the branch does, ``stepping`` says how long each step is,
``continuation`` strings branches together, ``switching`` begins those that part from one, and ``joining``
goes the other way, from doubled orbits to single ones and from asymmetric to symmetric ones; ``known`` says
what has been followed already. ``branch`` and ``special`` are the result.

``loci`` follows special points over two numbers.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
