"""Interconnections made by hand: one body with play and friction, and three bodies in a ring of frictions."""

from __future__ import annotations

import numpy as np

from trimmer.motion.backlash_component import BacklashComponent
from trimmer.motion.interconnection import Interconnection
from trimmer.motion.loops import Drive
from trimmer.motion.relay_component import RelayComponent
from trimmer.motion.switched_component import Component

GAP, TAU, LEVEL = 4e-5, 0.02, 0.7
RING = np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0], [1.0, 0.0, -1.0]])
MASSES = np.array([0.5, 2.0, 4.0])


def one_body(element: Component | None = None, second: Component | None = None) -> Interconnection:
    """Return x'' = -9 x - 0.2 x' + 5 u - 2 f with play from drive - x to u, and friction f of x.

    The extended state is x, x', place, velocity and share of the load, sine and cosine, one.
    """
    return Interconnection(
        A=np.array([[0.0, 1.0], [-9.0, -0.2]]),
        B=np.array([[0.0, 0.0], [5.0, -2.0]]),
        C=np.array([[-1.0, 0.0], [1.0, 0.0]]),
        D=np.zeros((2, 2)),
        drive_gain=np.array([1.0, 0.0]),
        components=(element or BacklashComponent(GAP, TAU), second or RelayComponent(LEVEL, True)),
        labels=("backlash", "friction"),
        drive=Drive(3e-4, 691.0, 0.3),
        element_factors=(1.0,),
    )


def ring_of_bodies(factors: tuple[float, ...] = (1.0, 1.0, 1.0), sign: float = -1.0) -> Interconnection:
    """Return three masses in a ring of frictions, with play before them and a friction on the ground after.

    Factors scale the outputs of those in the ring; a positive sign lets all frictions drive.
    """
    rows = np.vstack([np.zeros(3), RING, [0.0, 0.0, 1.0]])
    A = np.zeros((6, 6))
    A[:3, 3:] = np.eye(3)
    B = np.vstack([np.zeros((3, 5)), sign * np.array([1.0, *factors, 1.0]) * (rows / MASSES).T])
    B[3, 0] = 1.0
    return Interconnection(
        A=A,
        B=B,
        C=np.hstack([rows, np.zeros((5, 3))]),
        D=np.zeros((5, 5)),
        drive_gain=np.array([1.0, 0, 0, 0, 0]),
        components=(
            BacklashComponent(GAP, 0.0),
            *(RelayComponent(level, True) for level in (0.3, 0.5, 0.7, 0.9)),
        ),
        labels=("pin", "a", "b", "c", "d"),
        drive=None,
        element_factors=(1.0,),
    )
