"""The state space of python-control: beside the exact motion, eigenvalues of SciPy, responses; refusals."""

from dataclasses import replace

import control
import numpy as np
import pytest
from scipy.linalg import eigh

from trimmer import Friction, Link, Mechanism, MechanismError, Output, Pin, Play, Stop, TrimmerError, simulate
from trimmer.design.analysis.linear import all_drives, linear_state, linear_states
from trimmer.mechanism import Body, Force, OutputKind, linear_matrices

MACHINE = Mechanism(
    frequency=7.0,
    bodies={"frame": Body(mass=3.0), "tool": Body(mass=0.5)},
    pins={"eccentric": Pin("frame", amplitude=1e-3, phase=np.pi / 2)},
    links={
        "mount": Link(("ground", "frame"), stiffness=4e4, damping=30.0),
        "rod": Link(("eccentric", "tool"), stiffness=2e4, damping=25.0),
    },
    plays={"slot": Play(("frame", "tool"), stiffness=5e3, damping=4.0, gap=2.0)},
    stops={"end": Stop(("ground", "tool"), stiffness=9e3, damping=1.0, gap=1.0)},
    frictions={"guide": Friction(("frame", "tool"), force=0.0, viscous=3.0)},
    forces={"load": Force("tool", amplitude=2.0)},
    outputs={"stroke": Output({"tool": 1.0, "frame": -1.0}), "pin": Output({"eccentric": 2.0})},
)


def test_its_motion_is_the_exact_one_while_contacts_are_open() -> None:
    """From the pin at its largest displacement, at rest relative to its frame: a cosine begins."""
    system = MACHINE.state_space("open")
    assert system.input_labels == ["eccentric", "load"]
    assert system.output_labels == ["stroke", "pin"]
    assert system.state_labels == ["frame", "tool", "frame'", "tool'"]
    times = np.linspace(0.0, 1.0, 20_001)
    angle = 2 * np.pi * 7.0 * times
    driven = np.array([1e-3 * np.cos(angle), 2.0 * np.sin(angle)])
    # The states begin where displacements and velocities are 0 once the pin stands at 1 mm.
    kick = system.B[:, 0] * 1e-3
    start = np.concatenate([np.zeros(2), -kick[:2]])
    found = control.forced_response(system, times, driven, start).outputs
    motion = simulate(MACHINE, 1.0)
    for row, name in enumerate(MACHINE.outputs):
        expected = motion.output(name, times)
        assert abs(found[row] - expected).max() < 1e-5 * abs(expected).max()


@pytest.mark.parametrize("contacts", ["closed", "open", {"slot": "open"}, {"end": "open"}])
def test_its_response_and_its_poles_are_those_of_the_matrices(contacts: str | dict[str, str]) -> None:
    system = MACHINE.state_space(contacts)
    state = linear_state(MACHINE, contacts, all_drives(MACHINE))
    for each in state.transfer:
        inner = system[each.output, each.drive]
        expected = np.squeeze(inner(2j * np.pi * each.frequency))
        assert abs(expected - each.response).max() < 1e-12 * abs(each.response).max()
    poles = sorted(pole.imag / (2 * np.pi) for pole in system.poles() if pole.imag > 1e-6)
    assert poles == pytest.approx([mode.frequency for mode in state.modes], rel=1e-10)
    assert state.open == tuple(name for name in ("slot", "end") if _is_open(contacts, name))


def _is_open(contacts: str | dict[str, str], name: str) -> bool:
    return (contacts if isinstance(contacts, str) else contacts.get(name)) == "open"


def test_outputs_of_every_kind_have_the_response_of_their_kind() -> None:
    kinds = {
        "speed": Output({"tool": 1.0}, OutputKind.VELOCITY),
        "acceleration": Output({"tool": 1.0}, OutputKind.ACCELERATION),
        "rod": Output(kind=OutputKind.FORCE, part="rod"),
        "slot": Output(kind=OutputKind.FORCE, part="slot"),
        "guide": Output(kind=OutputKind.FORCE, part="guide"),
    }
    machine = replace(MACHINE, outputs={"tool": Output({"tool": 1}), "frame": Output({"frame": 1}), **kinds})
    s = 2j * np.pi * np.array([0.5, 3.0, 40.0, 900.0])
    for contacts, slot in (("closed", 5e3 + 4.0 * s), ("open", 0.0 * s)):
        tool, frame, *found = np.squeeze(machine.state_space(contacts, inputs=["load"])(s))
        between = tool - frame
        expected = (s * tool, s**2 * tool, (2e4 + 25.0 * s) * between, slot * between, 3.0 * s * between)
        for each, value in zip(found, expected, strict=True):
            np.testing.assert_allclose(each, value, rtol=1e-10, atol=1e-12)
    with pytest.raises(MechanismError, match="takes the velocity of pin 'eccentric'"):
        machine.state_space(outputs=["rod"])
    assert machine.state_space(inputs=["load"]).output_labels == list(machine.outputs)


def test_a_closed_contact_stands_beside_a_link_of_its_name() -> None:
    wall, rod = Stop(("ground", "a"), stiffness=90.0, damping=0.0, gap=1.0), Link(("ground", "a"), 10.0)
    forces, outputs = {"push": Force("a", amplitude=1.0)}, {"x": Output({"a": 1.0})}
    machine = Mechanism(
        {"a": Body(1.0)}, 1.0, links={"rod": rod}, stops={"rod": wall}, forces=forces, outputs=outputs
    )
    assert sorted(machine.state_space().poles().imag) == pytest.approx([-10.0, 10.0])


def test_undamped_modes_are_those_of_scipy() -> None:
    links = {name: Link(each.between, each.stiffness) for name, each in MACHINE.links.items()}
    undamped = Mechanism(MACHINE.bodies, 7.0, links=links, pins=MACHINE.pins)
    matrices = linear_matrices(undamped)
    squares, shapes = eigh(matrices.stiffness, matrices.mass)
    (state,) = linear_states(undamped)
    assert [mode.frequency for mode in state.modes] == pytest.approx(np.sqrt(squares) / (2 * np.pi))
    for mode, shape in zip(state.modes, shapes.T, strict=True):
        np.testing.assert_allclose(mode.shape, shape / shape[np.argmax(abs(shape))], atol=1e-9)


def test_inputs_and_outputs_are_chosen_by_name() -> None:
    system = MACHINE.state_space(inputs=["load"], outputs=["tool", "stroke"])
    assert (system.input_labels, system.output_labels) == (["load"], ["tool", "stroke"])
    whole = Mechanism(MACHINE.bodies, 7.0, links={"mount": MACHINE.links["mount"]}, forces=MACHINE.forces)
    assert whole.state_space().output_labels == ["frame", "tool"]


REFUSED = {
    "an unknown state": ({"contacts": "shut"}, "contacts is 'shut'"),
    "an unknown contact": ({"contacts": {"slott": "open"}}, "did you mean slot"),
    "an unknown input": ({"inputs": ["laod"]}, "did you mean load"),
    "an unknown output": ({"outputs": ["strike"]}, "did you mean stroke"),
    "a word for names": ({"outputs": "stroke"}, "sequence of names"),
    "a number for contacts": ({"contacts": 1}, "mapping by name"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_not_there_is_refused(case: str) -> None:
    arguments, sentence = REFUSED[case]
    with pytest.raises(TrimmerError, match=sentence):
        MACHINE.state_space(**arguments)  # type: ignore[arg-type]
