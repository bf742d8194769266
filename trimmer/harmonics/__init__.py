"""Harmonic balance of a mechanism with many harmonics, without a grid of times.

A ``waveform`` is a trigonometric polynomial; ``crossings`` finds all its zeros. Between them ``contact``
integrates the forces of plays and stops in closed form; ``balance`` those of frictions, and it solves.
"""
