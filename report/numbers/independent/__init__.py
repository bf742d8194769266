"""Second ways to numbers, written without what they confirm."""
