"""Formulas on their way to the page: read, broken into lines, repaired for browsers."""
