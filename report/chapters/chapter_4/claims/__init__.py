"""Claims: chapter 4, the nonlinearities in the simulation."""
