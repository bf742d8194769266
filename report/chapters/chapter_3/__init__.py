"""Chapter 3, experiment and simulation."""
