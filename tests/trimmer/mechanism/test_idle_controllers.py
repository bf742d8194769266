"""Controllers that never act, or never follow, are told; their zeros are taken as they are."""

import pytest

from trimmer import Mechanism
from trimmer.mechanism.controls.idle import idle_controllers

MACHINE = """
[bodies]
motor = { mass = 1.0 }
[links]
guide = { between = ["ground", "motor"], damping = 1.0 }
[outputs]
x = { motor = 1 }
[controllers.axis]
measure = "x"
reference = "path"
acts = ["ground", "motor"]
KIND
[references]
path = { step = 1.0 }
"""


@pytest.mark.parametrize(
    ("kind", "told"),
    [
        ('kind = "pid"', "never acts: kp, ki and kd are 0 where they are not given"),
        ('kind = "pid"\nki = 1.0', ""),
        ('kind = "cascade"\nkp = 3.0', "never acts: kv is 0 where it is not given"),
        ('kind = "cascade"\nkv = 0\nti = 1.0', "never acts: kv is 0 where it is not given"),
        (
            'kind = "cascade"\nkv = 2',
            "does not follow its reference, but brakes alone: kp is 0 where it is not given",
        ),
        ('kind = "cascade"\nkv = 2\nkp = 1', ""),
        (
            'kind = "transfer"\nnumerator = [0.0]\ndenominator = [1.0]',
            "never acts: all of its numerator is 0",
        ),
    ],
)
def test_what_never_acts_is_told(kind: str, told: str) -> None:
    mechanism = Mechanism.from_toml_text(MACHINE.replace("KIND", kind))
    assert list(idle_controllers(mechanism.controllers)) == ([f"controllers.axis {told}"] if told else [])
