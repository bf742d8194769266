"""What belongs to the trimmer of the thesis: its parameters, bodies, displacements, linear model and loop."""

from importlib import import_module
from typing import Any

PLACES = {
    "displacement": ("CUTTER_RELATIVE_TO_GUARD", "Displacement", "DisplacementError", "TrimmerBody"),
    "linear.model": ("InputChannels", "linear_model", "pin_model", "transfer_function"),
    "loops.trimmer_loop": ("BodyFriction", "TrimmerLoop"),
    "parameters": ("ParameterError", "TrimmerParameters", "parameter_table"),
}
"""The modules of ``trimmer`` that its names come from, each on first use."""
__all__ = [name for names in PLACES.values() for name in names]


def __getattr__(name: str) -> Any:
    for module, names in PLACES.items():
        if name in names:
            return getattr(import_module(f"trimmer.{module}"), name)
    raise AttributeError(f"trimmer.thesis has no {name!r}; it has {', '.join(sorted(__all__))}")


def __dir__() -> list[str]:
    return sorted(__all__)
