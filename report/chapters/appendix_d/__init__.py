"""Appendix D, the equations of motion."""
