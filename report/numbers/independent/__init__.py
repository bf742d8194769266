"""Second ways to numbers, and searches: pure functions for the chapters, which solve nothing themselves."""
