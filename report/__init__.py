"""The thesis's claims, what was found of each, and the report that shows it."""
