"""Machines with continuous controllers, beside digits found elsewhere, hand-written equations, and laws."""

from functools import lru_cache

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.trimmer.servos import SERVO
from trimmer import Body, Friction, Link, Mechanism, Output, Play, simulate
from trimmer.mechanism import (
    Cascade,
    Controller,
    OutputKind,
    Pid,
    ProfileReference,
    RampReference,
    Reference,
    SineReference,
    StepReference,
    TransferController,
)

ENDS = {"measure": "angle", "acts": ("ground", "motor"), "reference": "path"}


def machine(controller: Controller, reference: Reference, **others: object) -> Mechanism:
    """Return a motor with a load behind a dead zone, under control."""
    parts = {
        "bodies": {"motor": Body(inertia=2e-4), "load": Body(inertia=5e-4)},
        "links": {
            "bearing": Link(("ground", "motor"), damping=2e-3),
            "guide": Link(("ground", "load"), 0.05, 1e-3),
        },
        "plays": {"shaft": Play(("motor", "load"), 8.0, gap=0.02)},
        "outputs": {
            "angle": Output({"motor": 1, "load": 0.2}),
            "u": Output(kind=OutputKind.CONTROL, part="c"),
        },
    }
    return Mechanism(**parts | others, controllers={"c": controller}, references={"path": reference})


def test_the_integral_follows_the_limit() -> None:
    # shared/cases/servo.json, windup: the digits beyond 1e-13 are rounding there.
    axis = Pid(**ENDS, kp=1.0, ki=8.0, kd=0.05, filter_time=2e-3, limit=0.2)
    parts = {"bodies": {"motor": Body(inertia=1e-3)}, "plays": {}, "outputs": {"angle": Output({"motor": 1})}}
    links = {"bearing": Link(("ground", "motor"), damping=2e-3)}
    motion = simulate(machine(axis, StepReference(1.0), links=links, **parts), 5.0)
    assert motion.final["motor"] == pytest.approx((1.0, 0.0), abs=1e-12)
    assert motion.events == ()
    first = np.linspace(0.0, 1.0, 100001)
    assert motion.output("angle", first).max() == pytest.approx(1.10060827350674684, abs=1e-9)


CONTROLLERS = {
    "pid": Pid(**ENDS, kp=2.0, ki=20.0, kd=0.03, filter_time=3e-3, limit=0.3),
    "pid for ever": Pid(**ENDS, kp=2.0, ki=-5.0, limit=0.2, tracking=np.inf),
    "cascade": Cascade(**ENDS, kp=20.0, kv=0.05, ti=0.02, feedforward=0.7, limit=0.25),
    "proportional": Cascade(**ENDS, kp=20.0, kv=0.05),
    "transfer": TransferController(
        **ENDS, numerator=(0.0, 0.03, 2.0), denominator=(1e-6, 4e-3, 1.0), limit=0.2
    ),
    "Padé": Pid(**ENDS, kp=0.8, kd=0.02, filter_time=5e-3, limit=0.2, delay=4e-3, pade=3),
    "no delay": Pid(**ENDS, kp=0.8, kd=0.02, filter_time=5e-3, limit=0.2, pade=3),
}
REFERENCES = {
    "step": (StepReference(0.5, 0.05), lambda t: (0.5 * (t >= 0.05), 0.0)),
    "ramp": (RampReference(2.0, 0.1), lambda t: (max(2.0 * (t - 0.1), 0.0), 2.0 * (t >= 0.1))),
    "sine": (
        SineReference(0.4, 3.0, 1.0),
        lambda t: (0.4 * np.sin(6 * np.pi * t + 1), 2.4 * np.pi * np.cos(6 * np.pi * t + 1)),
    ),
    "profile": (
        ProfileReference(((0.05, 0.1), (0.15, 0.6), (0.2, 0.4))),
        lambda t: (
            np.interp(t, (0.05, 0.15, 0.2), (0.1, 0.6, 0.4)),
            5.0 if 0.05 <= t < 0.15 else -4.0 if 0.15 <= t < 0.2 else 0.0,
        ),
    ),
}
JUMPS = (0.05, 0.1, 0.15, 0.2, 0.3)


@lru_cache
def realized(numerator: tuple[float, ...], denominator: tuple[float, ...]) -> tuple[np.ndarray, ...]:
    return control.ssdata(control.ss(control.tf(numerator, denominator)))


def law(controller: Controller, x: np.ndarray, e: float, v: float, rate: float) -> tuple[np.ndarray, float]:
    """Return the rates of the states of a controller and what acts, as the definition says."""
    sat = np.inf if controller.limit is None else controller.limit
    follow = 0.0 if controller.tracking_time in (None, np.inf) else 1 / controller.tracking_time
    if isinstance(controller, Pid) and not controller.delay:
        d = controller.kd * (e - x[1]) / (controller.filter_time or 1.0)
        u = controller.kp * e + x[0] + d
        acts = np.clip(u, -sat, sat)
        filtered = (e - x[1]) / (controller.filter_time or 1.0)
        return np.array([controller.ki * e + follow * (acts - u), filtered]), acts
    if isinstance(controller, Cascade):
        f = controller.kp * e + controller.feedforward * rate - v
        integral = 0.0 if controller.ti is None else 1 / controller.ti
        u = controller.kv * f + x[0]
        acts = np.clip(u, -sat, sat)
        return np.array([controller.kv * integral * f + follow * (acts - u), 0.0]), acts
    if isinstance(controller, TransferController):
        a, b, c, d = realized(controller.numerator, controller.denominator)
        u = (c @ x + d[0] * e).item()
        return a @ x + b[:, 0] * e, np.clip(u, -sat, sat)
    a, b, c, d = realized(*map(tuple, control.pade(controller.delay, controller.pade)))
    slope = (e - x[0]) / controller.filter_time
    acts = np.clip(controller.kp * e + controller.kd * slope, -sat, sat)
    return np.array([slope, *(a @ x[1:] + b[:, 0] * acts)]), (c @ x[1:]).item() + d.item() * acts


def by_hand(controller: Controller, path: object, duration: float) -> np.ndarray:
    """Return angles and speeds at the end by DOP853, from the definition."""

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        q, v, x = y[:2], y[2:4], y[4:]
        r, rate = path(t)
        inner, u = law(controller, x, r - (q[0] + 0.2 * q[1]), v[0] + 0.2 * v[1], rate)
        stretch = q[1] - q[0]
        pull = 8.0 * (stretch - np.clip(stretch, -0.01, 0.01))
        motor = (u + pull - 2e-3 * v[0]) / 2e-4
        load = (-pull - 0.05 * q[1] - 1e-3 * v[1]) / 5e-4
        return np.array([*v, motor, load, *inner])

    states = 4 if isinstance(controller, Pid) and controller.delay else 2
    y, begin = np.zeros(4 + states), 0.0
    for end in (*(each for each in JUMPS if each < duration), duration):

        def before(t: float, y: np.ndarray, begin: float = begin, end: float = end) -> np.ndarray:
            return rates(min(max(t, begin), np.nextafter(end, 0.0)), y)

        found = solve_ivp(before, (begin, end), y, "DOP853", rtol=1e-10, atol=1e-13)
        y, begin = found.y[:, -1], end
    return y[:4]


@pytest.mark.parametrize(
    ("kind", "reference"),
    [
        *(("pid", each) for each in REFERENCES),
        ("pid for ever", "step"),
        *(("cascade", each) for each in REFERENCES),
        ("proportional", "ramp"),
        ("transfer", "step"),
        ("Padé", "sine"),
        ("no delay", "step"),
    ],
)
def test_motion_is_that_of_equations_written_by_hand(kind: str, reference: str) -> None:
    controller, (path, value) = CONTROLLERS[kind], REFERENCES[reference]
    motion = simulate(machine(controller, path), 0.25)
    found = np.transpose([motion.final["motor"], motion.final["load"]]).ravel()
    expected = by_hand(controller, value, 0.25)
    assert found == pytest.approx(expected, rel=1e-6, abs=1e-7 * abs(expected).max())
    assert motion.energy.residual < 1e-11


@pytest.mark.parametrize("kind", ["pid", "cascade", "Padé"])
def test_motion_is_mirrored_with_its_reference(kind: str) -> None:
    rubbing = {"guide": Friction(("ground", "load"), 0.02, 0.03)}
    there, back = (
        simulate(machine(CONTROLLERS[kind], StepReference(r, 0.02), frictions=rubbing), 0.3)
        for r in (0.4, -0.4)
    )
    assert back.final["load"] == tuple(-each for each in there.final["load"])
    assert [each.time for each in back.events] == [each.time for each in there.events]
    assert there.events


def test_what_a_limit_cuts_off_does_not_tear_out_of_stick() -> None:
    # The demand jumps to 6, and 0.05 acts: less than holds the motor.
    text = SERVO.replace("limit = 2.0", "limit = 0.05")
    motion = simulate(Mechanism.from_toml_text(text), 0.1)
    assert motion.events == ()
    assert motion.output("torque", np.array([0.005, 0.05])).tolist() == [0.0, 0.05]
    assert motion.final["motor"] == (0.0, 0.0)


def test_two_controllers_act_on_one_machine_in_the_frame_of_another_body() -> None:
    # A linear loop of python-control: the load is measured, and pushed against the motor.
    lead = TransferController(
        measure="twist", acts=("motor", "load"), numerator=(1e-3, 0.0), denominator=(1e-3, 1.0)
    )
    held = Pid(**ENDS, kp=0.7)
    outputs = {"angle": Output({"motor": 1}), "twist": Output({"load": 1, "motor": -1})}
    plain = machine(held, StepReference(0.3), outputs=outputs, plays={})
    both = Mechanism(
        plain.bodies, links=plain.links, outputs=outputs, references=plain.references,
        controllers={"held": held, "lead": lead},
    )  # fmt: skip
    mass, damping, stiffness = np.diag([2e-4, 5e-4]), np.diag([2e-3, 1e-3]), np.diag([0.0, 0.05])
    inverse, acts = np.linalg.inv(mass), np.array([[1.0, -1.0], [0.0, 1.0]])
    states = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ stiffness, -inverse @ damping]])
    given, read = np.vstack([np.zeros((2, 2)), inverse @ acts]), np.array([[1.0, 0, 0, 0], [-1.0, 1.0, 0, 0]])
    plant = control.ss(states, given, read, np.zeros((2, 2)))
    laws = control.append(control.ss([], [], [], [[0.7]]), control.ss(control.tf([1e-3, 0], [1e-3, 1])))
    closed = control.feedback(plant * laws, control.ss([], [], [], np.eye(2)))
    times = np.linspace(0.0, 0.5, 501)
    expected = 0.3 * control.step_response(closed, times, input=0).outputs[0, 0]
    assert simulate(both, 0.5).output("angle", times) == pytest.approx(expected, abs=1e-9)


def test_the_force_of_a_link_is_measured_with_its_stiffness_and_its_damping() -> None:
    inertia, stiffness, damping, kp, wanted = 5e-4, 0.05, 1e-3, 2.0, 0.01
    mechanism = Mechanism(
        bodies={"load": Body(inertia=inertia)},
        links={"guide": Link(("ground", "load"), stiffness, damping)},
        outputs={"force": Output(kind=OutputKind.FORCE, part="guide")},
        controllers={"c": Pid(measure="force", acts=("ground", "load"), reference="path", kp=kp)},
        references={"path": StepReference(wanted)},
    )

    def rates(_: float, y: np.ndarray) -> list[float]:
        force = stiffness * y[0] + damping * y[1]
        return [y[1], (kp * (wanted - force) - force) / inertia]

    end = solve_ivp(rates, (0.0, 0.6), [0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-15).y[:, -1]
    assert simulate(mechanism, 0.6).final["load"] == pytest.approx(tuple(end), rel=1e-9)
