"""Limit cycles by harmonic balance: all of them, with a certificate.

``solve`` is the way in, ``limit_cycle`` what comes out. The rest in the order of use: ``loop`` takes what is
linear in the element over to 1/G; ``inverse_response`` and ``element_curve`` bound 1/G and N; ``bounded`` or
``proportional`` find the solutions, the former with ``search``; ``cycles`` and ``stability`` describe them;
``winding_number`` checks them. ``leakage`` tests the filtering hypothesis.
"""
