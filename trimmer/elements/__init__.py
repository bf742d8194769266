"""Nonlinear elements with describing functions: backlash of three kinds, friction, relay, and their sums."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
