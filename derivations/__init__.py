"""Symbolic derivations, in SymPy only: the linear trimmer, and the describing functions of its elements."""
