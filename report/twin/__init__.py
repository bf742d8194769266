"""The chapter on the physical twin: its sentences with their evidence, its figures, its kept data."""
