"""Claims: chapter 3, experiment and simulation."""
