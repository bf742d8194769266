"""Limit cycles by harmonic balance: all of them, with a certificate.

``solve`` is the way in, ``limit_cycle`` what comes out. The rest in the order of use: ``inverse_response``
and ``element_curve`` bound 1/G and N; ``bounded`` or ``proportional`` choose the range and find the
solutions, the former with ``search``; ``cycles`` and ``stability`` describe them. ``leakage`` tests the
filtering hypothesis.
"""
