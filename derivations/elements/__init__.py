"""Backlash and friction: waveforms, harmonics, describing functions, and how their derivation is told."""
