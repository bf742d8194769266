"""Chaos, told from a long transient.

A trimmer with 120 um of play and 1.5 N of friction never repeats. Distances of neighbouring motions grow
by the Lyapunov exponent, given with its standard error. The points are the states at the start of each
drive period; a motion that repeats would show a few, a torus closed curves.

    it is chaotic
    Lyapunov exponent positive by more than three errors: True
"""

import matplotlib.pyplot as plt

from trimmer import Body, Friction, Link, Mechanism, Output, Pin, Play, respond

trimmer = Mechanism(
    frequency=110.0,
    bodies={"motor": Body(0.035), "cutter": Body(0.003), "guard": Body(0.035)},
    pins={"pin": Pin("motor", amplitude=1.5e-3)},
    links={
        "motor mount": Link(("ground", "motor"), stiffness=200e3, damping=3.5),
        "guard mount": Link(("ground", "guard"), stiffness=60e3, damping=4.0),
    },
    plays={"bridge": Play(("cutter", "pin"), stiffness=30e3, damping=0.4, gap=120e-6)},
    frictions={"blade": Friction(("guard", "cutter"), force=1.5)},
    outputs={"stroke": Output({"cutter": 1, "guard": -1})},
)
response = respond(trimmer)
exponent = response.motion.lyapunov
print(response.kind.value)
print(f"Lyapunov exponent positive by more than three errors: {exponent.value > 3 * exponent.uncertainty}")

figure, (motion, section) = plt.subplots(2, 1, figsize=(7, 6), layout="constrained")
response.plot(motion)
states = response.motion.window.states
section.plot(1e6 * states[:, 0], 1e6 * states[:, 2], ".", markersize=3)
section.set(xlabel="motor, um", ylabel="guard, um")
plt.show()
