"""Appendix A, the listings."""
