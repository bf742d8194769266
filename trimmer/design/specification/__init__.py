"""What is asked of a design: its file, its targets, and how large unknown numbers may be."""
