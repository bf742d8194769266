"""Claims: chapter 5, simulation and results."""
