"""Solvers and simulations of claims: other ways to what is derived, one topic a file."""
