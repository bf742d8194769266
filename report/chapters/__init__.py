"""The chapters of the thesis: their claims and their figures, each a record."""
