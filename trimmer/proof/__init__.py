"""Proofs by ball arithmetic of what was computed, and their check without what computed it.

``prove`` takes results and writes down the statement with its data; ``proof`` holds and reads proofs. The
check imports nothing of the solvers: ``statement``, what a file is about; ``balls``, exact numbers, roots and
Krawczyk's operator; ``described``, describing functions; ``proportional`` and ``plane``, all solutions of
harmonic balance; ``cycles`` holds a list against them; ``form``, whether a motion is told whole;
``following``, it in balls; ``pieces``, that there are no other events; ``returning``, that it returns;
``readings``, its extremes and means; ``motion_check`` and ``special_check`` say what that proves.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
