"""The loop of an element and the linear trimmer: harmonic balance, Newton's method and Loeb's rule."""
