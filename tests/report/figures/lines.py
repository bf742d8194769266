"""Curves of drawn figures."""

import numpy as np


def line(axes, label):
    """Return x and y of the one curve with a label."""
    (found,) = (each for each in axes.lines if each.get_label() == label)
    return np.asarray(found.get_xdata(), float), np.asarray(found.get_ydata(), float)


def curve(axes, label):
    """Return the one curve with a label as complex numbers."""
    real, imaginary = line(axes, label)
    return real + 1j * imaginary
