"""A mechanism analysed at one point: its motions, their signals and lines, its linear modes, its oddities."""
