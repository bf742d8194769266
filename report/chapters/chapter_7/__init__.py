"""Chapter 7, conclusion."""
