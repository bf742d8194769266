"""Exact periodic motions: Newton's method for a state that returns, its orbit, its multipliers."""
