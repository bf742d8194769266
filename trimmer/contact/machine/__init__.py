"""A mechanism as arrays, and the statuses of its parts: what its modes are written from."""
