"""Appendix E, further simulations."""
