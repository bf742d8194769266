"""Controllers in exact motion: their laws, what they add to a mode, and their limits."""
