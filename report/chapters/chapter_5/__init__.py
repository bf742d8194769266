"""Chapter 5, simulation and results."""
