"""Chapter 2, theory."""
