"""Vibration of a hair trimmer: its linear model, and what can be computed from it.

Names are imported from their modules when they are first used, so importing the package costs nothing; the
stub beside this file lists them:

    >>> from trimmer import TrimmerParameters, pin_model, resonance_peaks
    >>> peaks = resonance_peaks(pin_model(TrimmerParameters.thesis()))
"""

from __future__ import annotations

from typing import Any

import lazy_loader

_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__all__ += ["__version__"]


def __getattr__(name: str) -> Any:
    return _version() if name == "__version__" else _attribute(name)


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("trimmer")
    except PackageNotFoundError:
        return "unknown (not installed)"
