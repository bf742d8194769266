"""Harmonic balance of a mechanism with many harmonics, without a grid of times.

A ``waveform`` is a trigonometric polynomial; ``crossings`` finds all its zeros. Between them ``contact`` and
``rubbing`` integrate the forces of plays, stops and frictions in closed form; ``balance`` solves.
"""
