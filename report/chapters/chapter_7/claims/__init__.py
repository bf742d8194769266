"""Claims: chapter 7, conclusion."""
