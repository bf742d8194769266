"""Maps of motions: what a mechanism settles to, over two of its numbers or over two initial values.

``settle`` follows one motion until it has settled, ``by_itself`` one without a drive, and ``measures``
measures them; a ``cell_motion`` is told from others, and ``cells`` does the work of a cell. ``inputs`` checks
what a map is made from, and ``checkpoint`` keeps cells in a file. ``motion_map`` puts these together into a
``result``, ``basin`` varies the start instead of the mechanism, and ``coexistence`` looks for motions that no
start of the map led to. ``run_up`` varies a number while the motion goes on: a ``plateau`` for each value,
``jumps`` between them, and all as ``swept``.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
