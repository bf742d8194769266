"""Claims: appendix A, the listings."""
