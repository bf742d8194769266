"""The claims of the thesis, one module for each section or appendix."""
