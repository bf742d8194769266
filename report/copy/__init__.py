"""The reader's own text copy of the thesis: reading it, and finding places in it."""
