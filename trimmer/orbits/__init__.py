"""Exact periodic motions of switched loops: period, waveform, Floquet multipliers.

``periodic_orbits`` and ``forced_orbit`` are the entries, ``periodic_orbit`` is the result, which ``describe``
fills. Newton's method is that of ``trimmer.response.periodic.shooting``; it starts from a ``guess`` on the
first harmonic or from a ``balanced_start`` on several, for which ``multi_harmonic_balance`` uses
``steady_response`` and ``trigonometric``; from the zeros of a relay's ``half_period`` equation; or from where
long simulations settle (``settling``). ``distinct`` says whether two orbits are one.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
