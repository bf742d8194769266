"""Pictures of mechanisms: motions, branches, maps, samples of a series."""
