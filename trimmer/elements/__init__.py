"""Nonlinear elements with describing functions: backlash of three kinds, friction, relay, and their sums."""
