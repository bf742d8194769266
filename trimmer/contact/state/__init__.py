"""The state of a mechanism in exact motion: its frame, its entries, and the references that force it."""
