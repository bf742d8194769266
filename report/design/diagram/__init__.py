"""A mechanism drawn from its data: where its parts stand, and how each looks."""
