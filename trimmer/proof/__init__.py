"""Proofs by ball arithmetic of what was computed, and their check without what computed it.

``prove`` takes results and writes down the statement with its data; ``proof`` holds and reads proofs. The
check imports nothing of the solvers: ``statement``, what a file is about; ``balls``, exact numbers;
``described``, describing functions; ``proportional`` and ``plane``, all solutions of harmonic balance;
``cycles`` holds a list against them; ``form``, whether a motion is told whole; ``following``, it in balls;
``returning``, that it returns; ``pieces``, that there are no other events; ``readings``, its extremes and
means; ``motion_check``, the same of a motion from a state.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
