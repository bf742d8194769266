"""Modes and transfer functions of a mechanism of three bodies, against its equations written out."""

from dataclasses import replace

import numpy as np
import pytest

from trimmer.design.analysis.linear import driving, linear_states
from trimmer.mechanism import ContactLaw, Contacts, Mechanism

THREE = Mechanism.from_toml_text("""
    frequency = 7.0
    [bodies]
    a = { mass = 0.5 }
    b = { mass = 0.2 }
    c = { mass = 0.1 }
    [pins]
    still = { on = "a" }
    shaker = { on = "b", amplitude = 1e-3, order = 2 }
    [links]
    ground = { between = ["ground", "a"], stiffness = 900.0, damping = 0.7 }
    join = { between = ["a", "b"], stiffness = 400.0, damping = 0.3 }
    drive = { between = ["shaker", "c"], stiffness = 250.0, damping = 0.9 }
    [plays]
    play = { between = ["ground", "c"], stiffness = 60.0, damping = 0.05, gap = 4e-5 }
    [frictions]
    oil = { between = ["ground", "b"], force = 0.3, viscous = 0.4 }
    [forces]
    none = { on = "b" }
    push = { on = "b", amplitude = 2.0, order = 3 }
    whirl = { on = "a", unbalance = 1e-4 }
    [outputs]
    mixed = { a = 1, c = -2, shaker = 3 }
    plain = { c = 1 }
""")
MASS = np.diag([0.5, 0.2, 0.1])
STIFFNESS = np.array([[1300.0, -400.0, 0.0], [-400.0, 650.0, -250.0], [0.0, -250.0, 250.0]])
DAMPING = np.array([[1.0, -0.3, 0.0], [-0.3, 1.6, -0.9], [0.0, -0.9, 0.9]])
PLAIN = np.array([0.0, 0.0, 1.0])
MIXED = np.array([1.0, 3.0, -2.0])


def answers(frequency: float, closed: bool) -> dict[tuple[str, str], complex]:
    """Return what each output does for a unit of each drive."""
    s = 2j * np.pi * frequency
    corner = np.diag([0.0, 0.0, 1.0])
    dynamic = MASS * s**2 + DAMPING * s + STIFFNESS + closed * (60.0 + 0.05 * s) * corner
    link = 250.0 + 0.9 * s
    pushes = {"shaker": [0.0, -link, link], "push": [0.0, 1.0, 0.0], "whirl": [1.0, 0.0, 0.0]}
    found = {}
    for drive, push in pushes.items():
        moved = np.linalg.solve(dynamic, np.array(push))
        found[drive, "mixed"] = complex(MIXED @ moved + 3.0 * (drive == "shaker"))
        found[drive, "plain"] = complex(PLAIN @ moved)
    return found


def test_pins_and_forces_that_vibrate_drive() -> None:
    assert driving(THREE) == [("shaker", "m", 2), ("push", "N", 3), ("whirl", "N", 1)]


def test_modes_solve_the_equations_of_motion() -> None:
    closed, opened = linear_states(THREE)
    assert (closed.contacts, opened.contacts) == (Contacts.CLOSED, Contacts.OPEN)
    for state, share in ((closed, 1.0), (opened, 0.0)):
        assert state.bodies == ("a", "b", "c")
        assert len(state.modes) == 3
        assert (state.rigid, state.decaying) == (0, 0)
        frequencies = [mode.frequency for mode in state.modes]
        assert frequencies == sorted(frequencies)
        for mode in state.modes:
            omega = 2 * np.pi * mode.frequency
            s = omega * (1j - mode.damping_ratio / np.sqrt(1 - mode.damping_ratio**2))
            corner = share * np.diag([0.0, 0.0, 60.0 + 0.05 * s])
            left = (MASS * s**2 + DAMPING * s + STIFFNESS + corner) @ mode.shape
            assert abs(left).max() < 1e-9 * 1300
            assert abs(mode.shape).max() == pytest.approx(1.0)
            assert mode.shape[np.argmax(abs(mode.shape))] == pytest.approx(1.0)


def test_transfer_functions_are_those_of_the_written_equations() -> None:
    for state, closed in zip(linear_states(THREE), (True, False), strict=True):
        marks = [7.0, *(mode.frequency for mode in state.modes)]
        at_drive = {"shaker": 14.0, "push": 21.0, "whirl": 7.0}
        assert [(each.drive, each.output, each.unit) for each in state.transfer] == [
            (drive, name, "m" if drive == "shaker" else "N")
            for drive in at_drive
            for name in ("mixed", "plain")
        ]
        for each in state.transfer:
            key = each.drive, each.output
            assert each.at_drive == pytest.approx(answers(at_drive[each.drive], closed)[key], rel=1e-10)
            assert each.frequency[[0, -1]] == pytest.approx([min(marks) / 20, max(marks) * 3])
            assert np.ptp(np.diff(np.log(each.frequency))) < 1e-12
            for place in (0, 700, 1500, -1):
                expected = answers(float(each.frequency[place]), closed)[key]
                assert each.response[place] == pytest.approx(expected, rel=1e-9)


def one(links: str, frequency: str = "") -> Mechanism:
    return Mechanism.from_toml_text(f"""
        {frequency}
        bodies.block = {{ mass = 2.0 }}
        forces.push = {{ on = "block", constant = 1.0 }}
        {links}
    """)


def test_motions_that_do_not_swing_are_counted() -> None:
    def counts(mechanism: Mechanism) -> tuple[int, int, int]:
        (state,) = linear_states(mechanism)
        return len(state.modes), state.rigid, state.decaying

    assert counts(one("")) == (0, 1, 0)
    assert counts(one('links.d = { between = ["ground", "block"], damping = 3.0 }')) == (0, 1, 1)
    heavy = 'links.d = { between = ["ground", "block"], stiffness = 1.0, damping = 9.0 }'
    assert counts(one(heavy)) == (0, 0, 2)
    light = 'links.d = { between = ["ground", "block"], stiffness = 1.0, damping = 0.1 }'
    assert counts(one(light)) == (1, 0, 0)


def test_what_floats_is_rigid_although_its_eigenvalues_are_rounded() -> None:
    floating = Mechanism.from_toml_text("""
        bodies = { a = { mass = 0.3 }, b = { mass = 0.7 }, c = { mass = 1.1 } }
        links.join = { between = ["a", "b"], stiffness = 413.0, damping = 0.3 }
        links.last = { between = ["b", "c"], stiffness = 97.0, damping = 0.7 }
        outputs.a = { a = 1 }
    """)
    (state,) = linear_states(floating)
    assert (len(state.modes), state.rigid, state.decaying) == (2, 1, 0)


def test_a_contact_that_exerts_nothing_has_no_closed_state() -> None:
    air = replace(THREE, plays={"play": replace(THREE.plays["play"], stiffness=0.0, damping=0.0)})
    (state,) = linear_states(air)
    assert state.contacts is Contacts.CLOSED
    for changes in ({"stiffness": 0.0, "law": ContactLaw.TRUNCATED}, {"damping": 0.0}):
        half = replace(THREE, plays={"play": replace(THREE.plays["play"], **changes)})
        assert [each.contacts for each in linear_states(half)] == [Contacts.CLOSED, Contacts.OPEN]
    opened = linear_states(THREE)[1]
    assert [mode.frequency for mode in state.modes] == pytest.approx([m.frequency for m in opened.modes])
