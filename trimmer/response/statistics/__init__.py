"""Statistics of what does not repeat: means with their errors, growth, and the 0-1 test for chaos."""
