"""Limit cycles by harmonic balance: all of them, with a certificate.

``solve`` is the entry, ``limit_cycle`` holds the results. The rest in the order of use: ``loop`` moves what
is linear in the element (``linear_part``) to 1/G; ``inverse_response`` and ``element_curve`` bound 1/G and N;
``bounded`` or ``proportional`` find the solutions, the former with ``search``, which covers the plane with
``cells`` and rests on ``exclusion`` and ``uniqueness``; ``stability`` turns solutions into limit cycles;
``winding_number`` checks them, in a range that ``rational`` finds; ``factoring_error`` is what the poles and
zeros are off. ``leakage`` tests the filtering hypothesis, ``identification`` solves for the load's time
constant instead of the frequency.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
