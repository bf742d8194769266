"""Figures: chapter 2, theory."""
