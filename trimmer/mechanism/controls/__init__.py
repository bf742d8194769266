"""Controllers and references as data: what they are, read and written, and whether they fit."""
