"""The loop of an element and the linear trimmer: harmonic balance, Loeb's rule, and how a solution is found."""
