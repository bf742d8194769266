"""Backlash and friction: waveforms, harmonics, describing functions, and their derivation step by step."""
