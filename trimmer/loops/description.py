"""A loop as data that tell it from any other one: what it is made of, to the last digit."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import control
import numpy as np

from trimmer.loops.feedback import Feedback
from trimmer.loops.loops import COMPUTED


def loop_as_data(part: Any) -> Any:
    """Return a loop, or a part of one, as lists, dictionaries, numbers and text."""
    if isinstance(part, control.StateSpace):
        return {name: np.asarray(getattr(part, name)).tolist() for name in "ABCD"}
    if isinstance(part, control.TransferFunction):
        return {name: np.asarray(getattr(part, name)[0][0]).tolist() for name in ("num", "den")}
    if is_dataclass(part) and not isinstance(part, type):
        own = {each.name: loop_as_data(getattr(part, each.name)) for each in fields(part)}
        if isinstance(part, Feedback):
            own["signals"] = [part.plant.input_labels, part.plant.output_labels]
        return {"kind": type(part).__name__} | {
            name: one for name, one in own.items() if name not in COMPUTED
        }
    if isinstance(part, Mapping):
        return {name: loop_as_data(each) for name, each in part.items()}
    if isinstance(part, tuple):
        return [loop_as_data(each) for each in part]
    return part if part is None or isinstance(part, bool | int | float | str) else repr(part)
