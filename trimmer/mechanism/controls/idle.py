"""Controllers that do nothing, as a gain was left out: 0 is what a file means by that, and it is taken so."""

from collections.abc import Iterator, Mapping

from trimmer.mechanism.controls.controllers import Cascade, Controller, Pid, TransferController
from trimmer.mechanism.place_text import place_text


def idle_controllers(controllers: Mapping[str, Controller]) -> Iterator[str]:
    """Yield a sentence on each controller that never acts, or never follows its reference."""
    for name, each in controllers.items():
        if reason := _reason(each):
            yield f"{place_text(('controllers', name))} {reason}"


def _reason(controller: Controller) -> str:
    match controller:
        case Pid(kp=0, ki=0, kd=0):
            return "never acts: kp, ki and kd are 0 where they are not given"
        case Cascade(kv=0):
            return "never acts: kv is 0 where it is not given"
        case Cascade(kp=0, reference=str()):
            return "does not follow its reference, but brakes alone: kp is 0 where it is not given"
        case TransferController() if not any(controller.numerator):
            return "never acts: all of its numerator is 0"
        case _:
            return ""
