"""Limit cycles of many trimmers at once, each with its own parameters and gap."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
