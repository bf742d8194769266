"""What a mechanism settles to: exact periodic motions, and statistics of those that do not repeat.

``shooting`` solves for a state that returns, ``orbit`` is what it gives and ``forced_orbit`` its entry;
``self_excited`` does the same without a drive, where the period is unknown. ``motion_signals`` names what is
measured, ``extremes`` and ``fourier`` measure it, ``measures`` collects the results.
"""
