"""Claims: chapter 2, theory."""
