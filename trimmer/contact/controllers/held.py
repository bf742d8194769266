"""Where sampled controllers keep what they hold: their states, what is on its way, and what acts."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from trimmer.contact.controllers.sampled_laws import law_of
from trimmer.hybrid.clock import TOGETHER
from trimmer.mechanism.controls.controllers import Controller


class Held(NamedTuple):
    """Places in the extended state of what a sampled controller holds."""

    sample: float  # s
    states: tuple[int, ...]  # Of the states of its law
    waiting: tuple[int, ...]  # Of what was demanded and is on its way, the oldest first
    acting: int  # Of what acts; the first of these if it acts at a sample
    delay: float  # Time after a sample at which what it demanded acts, s; 0 if that is another sample
    end: int  # The place behind all

    @property
    def places(self) -> tuple[int, ...]:
        """All of them, once."""
        return tuple(dict.fromkeys((*self.states, *self.waiting, self.acting)))


def held_by(controllers: Mapping[str, Controller], first: int) -> dict[str, Held]:
    """Return what each sampled controller holds, from a place in the extended state on."""
    found = {}
    for name, controller in controllers.items():
        if controller.sample is not None:
            found[name] = _held(controller, controller.sample, first)
            first = found[name].end
    return found


def _held(controller: Controller, sample: float, first: int) -> Held:
    """Return what one holds: after a delay of m samples and a rest, the last m + 1 demands."""
    whole = math.floor(controller.delay / sample + TOGETHER)
    behind = first + len(law_of(controller).states)
    states, waiting = tuple(range(first, behind)), tuple(range(behind, behind + whole + 1))
    at_once = controller.delay - whole * sample <= TOGETHER * sample
    acting = waiting[0] if at_once else waiting[-1] + 1
    return Held(
        sample, states, waiting, acting, 0.0 if at_once else controller.delay, max(acting, waiting[-1]) + 1
    )
