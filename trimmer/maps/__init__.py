"""Maps of motions: what a mechanism settles to, over two of its numbers or over two initial values.

``settle`` follows one motion until it has settled, ``same`` tells orbits apart, and ``measures`` measures
them; ``cells`` makes of this the work of a cell. ``inputs`` checks what a map is made from, ``runner`` does
cells in several processes, and ``checkpoint`` keeps them in a file. ``motion_map`` puts these together into a
``result``, ``basin`` varies the start instead of the mechanism, and ``coexistence`` looks for motions that no
start of the map led to. ``run_up`` varies a number while the motion goes on: a ``plateau`` for each value,
``jumps`` between them, and all as ``swept``. ``drawing`` draws them.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
