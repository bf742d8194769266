"""MuJoCo: a soft wall as a limit of a joint with stiffness and damping; dry friction of a joint."""

import math

import mujoco

from benchmarks.peers.telling import tell

WALL = """<mujoco><option gravity="0 0 0" timestep="{step}" integrator="{integrator}"/><worldbody><body>
<joint name="x" type="slide" axis="1 0 0" limited="true" range="-5 0"
solreflimit="-1 {damping}" solimplimit="0.9999 0.9999 0.001"/>
<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody></mujoco>"""
BELT = """<mujoco><option gravity="0 0 0" timestep="{step}" integrator="{integrator}"/><worldbody><body>
<joint name="x" type="slide" axis="1 0 0" stiffness="1" frictionloss="0.2"/>
<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody></mujoco>"""
SETTINGS = {"Euler, 2 ms (defaults)": ("Euler", 2e-3), "RK4, 1 ms": ("RK4", 1e-3)}


def rebound(integrator: str, step: float) -> float:
    """Return the speed of rebound of a body that comes with 1, damping ratio 0.1."""
    model = mujoco.MjModel.from_xml_string(WALL.format(step=step, integrator=integrator, damping=-0.2))
    data = mujoco.MjData(model)
    data.qpos[0], data.qvel[0] = -1.0, 1.0
    for _ in range(round(9.0 / step)):
        mujoco.mj_step(model, data)
    return -float(data.qvel[0])


def dry_friction(integrator: str, step: float) -> float:
    """Return half of peak to peak of Den Hartog's oscillator, r = 0.7, over its 40th period."""
    model = mujoco.MjModel.from_xml_string(BELT.format(step=step, integrator=integrator))
    data = mujoco.MjData(model)
    period, places = 2 * math.pi / 0.7, []
    for number in range(round(40 * period / step)):
        data.qfrc_applied[0] = math.cos(0.7 * data.time)
        mujoco.mj_step(model, data)
        if number * step > 39 * period:
            places.append(float(data.qpos[0]))
    return 0.5 * (max(places) - min(places))


if __name__ == "__main__":
    name = f"MuJoCo {mujoco.__version__}"
    for setting, (integrator, step) in SETTINGS.items():
        tell(name, setting, "soft-wall", "rebound at zeta = 0.1", lambda i=integrator, s=step: rebound(i, s))
        tell(
            name,
            setting,
            "den-hartog",
            "amplitude at r = 0.7, b = 0.2",
            lambda i=integrator, s=step: dry_friction(i, s),
        )
