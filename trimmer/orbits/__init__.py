"""Exact periodic motions of switched loops: period, waveform, Floquet multipliers."""
