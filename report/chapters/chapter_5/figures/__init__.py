"""Figures: chapter 5, simulation and results."""
