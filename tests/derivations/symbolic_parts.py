"""Parts of mechanisms for tests, with short symbols."""

import sympy

from derivations.parts import ContactLaw, Force, Friction, Ground, Pin, Play, RigidBody, Stop
from derivations.symbols import t

GROUND = Ground()


def function(name):
    return sympy.Function(name, real=True)(t)


def positive(name):
    return sympy.Symbol(name, positive=True)


def body(index):
    return RigidBody(f"body {index}", positive(f"m_{index}"), function(f"q_{index}"))


def pin(name, carrier):
    return Pin(carrier, function(name))


def force(name, on):
    return Force(on, function(name))


def _contact(name, start, end, law, damping, gap):
    return {
        "name": name,
        "stiffness": positive(f"k_{name}"),
        "damping": positive(f"c_{name}") if damping else sympy.S.Zero,
        "gap": positive(f"g_{name}") if gap else sympy.S.Zero,
        "start": start,
        "end": end,
        "distance": function(f"s_{name}"),
        "stretch": function(f"z_{name}"),
        "tension": function(f"T_{name}"),
        "law": law,
    }


def play(name, start, end, law=ContactLaw.RELAXING, damping=True, gap=True):
    side = sympy.Symbol(f"sigma_{name}", real=True)
    return Play(**_contact(name, start, end, law, damping, gap), side=side)


def stop(name, start, end, law=ContactLaw.RELAXING, damping=True, gap=True):
    return Stop(**_contact(name, start, end, law, damping, gap))


def friction(name, start, end, viscous=True):
    return Friction(
        name,
        positive(f"F_{name}"),
        positive(f"H_{name}"),
        positive(f"d_{name}") if viscous else sympy.S.Zero,
        start,
        end,
        function(f"v_{name}"),
        function(f"f_{name}"),
    )
