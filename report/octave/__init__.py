"""Appendix A of the thesis as corrected MATLAB/Octave programs, printed from the derivations."""
