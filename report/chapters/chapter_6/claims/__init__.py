"""Claims: chapter 6, discussion."""
