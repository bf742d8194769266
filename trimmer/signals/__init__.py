"""Sampled signals and their files.

``signal`` is what the rest works on. ``read`` reads one from a CSV file, in this order: ``text_file`` gives
text, ``csv_layout`` and ``csv_table`` rows and headings, ``columns`` the columns that are meant, ``cells``
numbers; ``time_stamps`` finds the rate and gaps, ``sampling`` decides what is done about them, and a
``recording`` holds the stretches. ``read_wav`` reads sound.
``quantity`` is what a signal is by its unit, ``band`` where it can be trusted, ``faults`` what is wrong with
it. ``convert`` makes displacement, velocity and acceleration of one another, with ``noise_floor`` and
``omega_kernel``. ``write`` writes CSV and ``wav`` audio.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
