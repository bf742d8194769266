"""Symbolic derivations, in SymPy only: energies, equations of motion, state space and transfer functions."""
