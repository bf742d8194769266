"""Chapter 6, discussion."""
