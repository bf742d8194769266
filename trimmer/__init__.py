"""What play and dry friction do in a machine or a control loop: motions, branches, maps, limit cycles.

Names are imported from their modules when they are first used, so importing the package costs nothing; the
stub beside this file lists those at the top:

    >>> from trimmer import TrimmerParameters, pin_model, resonance_peaks
    >>> peaks = resonance_peaks(pin_model(TrimmerParameters.thesis()))

What is asked for less often stands in rooms, such as ``trimmer.elements``, ``trimmer.signals`` and
``trimmer.thesis``. A name that is looked for at the top is found there too, with a warning that says where.
"""

from importlib import import_module
from typing import Any
from warnings import warn

import lazy_loader

_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__all__ += ["__version__"]
ROOMS = (
    *("balance", "branches", "choices", "design", "elements", "ensembles", "errors", "files", "fitting"),
    *("linear", "loops", "maps", "mechanism", "motion", "orbits", "proof", "response", "runners"),
    *("signals", "spectra", "thesis", "uncertainty"),
)
"""Packages and modules with public names that are not at the top."""


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return _version()
    if name in __all__ or name.startswith("_"):
        return _attribute(name)
    if name in ROOMS:
        return import_module(f"{__name__}.{name}")
    return _in_a_room(name)


def _in_a_room(name: str) -> Any:
    """Return what stands in a room under a name, with a warning; else it is an error as for any package."""
    for room in ROOMS:
        place = import_module(f"{__name__}.{room}")
        if name in place.__all__:
            told = f"trimmer.{name} stands in trimmer.{room}: from trimmer.{room} import {name}"
            warn(told, DeprecationWarning, stacklevel=3)
            return getattr(place, name)
        if name in getattr(place, "FORMER", ()):
            return getattr(place, name)
    return _attribute(name)


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("trimmer")
    except PackageNotFoundError:
        return "unknown (not installed)"
