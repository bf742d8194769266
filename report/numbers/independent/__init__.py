"""Second ways to what claims derive: numerics that use nothing of the first way."""
