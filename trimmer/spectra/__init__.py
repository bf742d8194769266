"""Spectra of sampled signals, their peaks, and what these may be.

In the order of use: ``window`` and ``spectrum`` give the amplitude spectrum, ``peaks`` its peaks
between bins, with ``noise`` for what is none; ``harmonics`` fits the harmonics of a known drive to the
samples; ``classification`` says what a peak may be; ``analysis`` does all of that for one signal.
``averaged`` averages spectra of segments; ``comparison`` holds a measured motion against a simulated one.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
