"""Exact motion of a linear system with switched elements: the flow between events is known in closed form."""
