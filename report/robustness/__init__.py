"""How far the corrected results hold when the parameters of the thesis are not exactly those of a trimmer."""
