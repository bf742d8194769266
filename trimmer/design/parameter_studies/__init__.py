"""What depends on one or two numbers of a design: maps, branches, grids of motions, as far as kept."""
