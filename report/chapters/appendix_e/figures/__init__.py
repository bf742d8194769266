"""Figures: appendix E, further simulations."""
