"""A mechanism as data: bodies, and what holds, pushes and rubs them.

``parts`` are the parts, ``mechanism`` puts them together, ``reading`` and ``writing`` are its TOML file:

    >>> from trimmer import Body, Link, Mechanism
    >>> oscillator = Mechanism({"mass": Body(1.0)}, links={"spring": Link(("ground", "mass"), stiffness=1.0)})
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
