"""Controllers and references as data: files, places, units, and what is said of those that will not do."""

import math

import control
import numpy as np
import pytest

from trimmer import Body, Link, Mechanism, MechanismError, Output
from trimmer.mechanism import (
    Cascade,
    OutputKind,
    Pid,
    ProfileReference,
    RampReference,
    SineReference,
    StepReference,
    TransferController,
)
from trimmer.mechanism.controls.controllers import idle_controllers

TEXT = """\
[bodies]
motor = { inertia = 2e-4 }
slide = { mass = 0.5 }
[points]
rack = { motor = "10 mm" }
[pins]
base = { on = "motor" }
[links]
belt = { between = ["rack", "slide"], stiffness = 1e4 }
[frictions]
guide = { between = ["ground", "slide"], force = 1.0 }
[outputs]
angle = { motor = 1 }
rate = { velocity = { motor = 1 } }
way = { slide = 1 }
shaking = { acceleration = { slide = 1 } }
rubbing = { force = "guide" }
pull = { force = "belt" }
torque = { control = "axis" }
[controllers]
axis = { kind = "pid", measure = "angle", acts = ["ground", "motor"], kp = "2 N m/rad" }
"""
AXIS = TEXT.splitlines()[-1]


def axis(**keys: str) -> str:
    """Return the text with other keys of the controller, as TOML."""
    given = {"kind": '"pid"', "measure": '"angle"', "acts": '["ground", "motor"]'} | keys
    return TEXT.replace(AXIS, f"axis = {{ {', '.join(f'{key} = {value}' for key, value in given.items())} }}")


def cascade(**keys: str) -> str:
    return axis(kind='"cascade"', **keys)


def transfer(**keys: str) -> str:
    return axis(kind='"transfer"', **{"numerator": "[1]", "denominator": "[1, 2]"} | keys)


def reference(text: str) -> str:
    return axis(reference='"path"') + f"[references]\npath = {text}\n"


WRONG = {
    axis(kind='"pdi"'): "line 21: controllers.axis.kind = 'pdi': did you mean pid?",
    TEXT.replace('kind = "pid", ', ""): "controllers.axis.kind: missing; write one of 'pid', 'cascade' or",
    axis(filter="1e-3"): "line 21: controllers.axis.filter = 0.001: unknown key; did you mean filter_time?",
    axis(kv="1"): "controllers.axis.kv = 1: unknown key",
    TEXT.replace('measure = "angle", ', ""): 'controllers.axis.measure: missing; add measure = "angle"',
    axis(measure='"angel"'): "axis.measure = 'angel': there is no output 'angel'; did you mean angle?",
    # A unit cannot be judged beside a name that nothing has.
    axis(measure='"angel"', kp='"2 N m/rad"'): "line 21: controllers.axis.measure = 'angel': there is no",
    axis(acts='["ground", "motr"]', kp='"2 N m/rad"'): "point 'motr'; did you mean motor?",
    axis() + "[references]\npath = { step = '1 deg' }\n": "references.path.step = '1 deg': no controller",
    axis() + "[references]\npath = { profile = [[0, 0], [1, '1 deg']] }\n": "profile.2.value = '1 deg': no",
    axis() + "[references]\npath = { sine = 1, frequency = '5 m' }\n": "path.frequency = '5 m': 'm' does",
    axis(reference='["path"]') + "[references]\npath = { step = 1 }\n": "axis.reference = ['path']: ",
    axis(reference='"path"'): "axis.reference = 'path': there is no reference 'path'; there is none",
    axis(acts='"motor"'): ': name two ends, as in ["ground", "motor"]',
    axis(acts='["ground", "base"]'): "a pin moves as prescribed; name what carries it, 'motor'",
    axis(acts='["motor", "slide"]'): "'motor' is a rotation and 'slide' a translation",
    axis(acts='["motor", "motor"]'): "both ends are the same; name two different ones",
    axis(kp='"2 N/m"'): "controllers.axis.kp = '2 N/m': 'N/m' does not measure what N m/rad does",
    axis(kd="1"): "controllers.axis.filter_time = 0.0: a gain kd needs a filter_time",
    axis(limit="0"): "controllers.axis.limit = 0: must be greater than zero, in N m",
    axis(ki="1", limit="1"): "controllers.axis.tracking: missing; a limit and an integral part need",
    axis(kp="1", ki="1", tracking="1"): "tracking = 1: the integral follows a limit, and there is none",
    axis(kp="1", limit="1", tracking="1"): "limit, since ki is 0; give ki, or leave",
    cascade(kp="1", kv="1", limit="1", tracking="1"): "limit, since ti is missing; give ti, or leave this",
    axis(ki="1", limit="1", sample="1e-3", tracking="1e-4"): "must not be shorter than the sample, 0.001 s",
    axis(ki="1", limit="1", tracking="0"): "tracking = 0: must be greater than zero, or inf, in s",
    axis(delay="1e-3"): "controllers.axis.delay = 0.001: a delay needs a sample, or pade = 3",
    axis(sample="1e-3", pade="2"): "controllers.axis.pade = 2: a sampled controller delays exactly",
    axis(sample="0"): "controllers.axis.sample = 0: must be greater than zero, in s",
    axis(pade="1.5"): "controllers.axis.pade = 1.5: must be a whole number from 1 on",
    axis(measure='"pull"').replace("1e4 }", "1e4, curve = [[0, 0], [1, 2]] }"): (
        "controllers.axis.measure = 'pull': a continuous controller that measures the force of a curve"
    ),
    axis(measure='"shaking"'): "an algebraic loop, 'axis' -> 'shaking' -> forces -> 'axis'",
    axis(measure='"rubbing"'): "an algebraic loop, 'axis' -> 'rubbing' -> 'guide' -> 'axis'",
    axis(measure='"torque"'): "axis.measure = 'torque': an algebraic loop, 'axis' -> 'torque' -> 'axis'",
    cascade(speed='"difference"'): "axis.speed = 'difference': a difference is that of two samples",
    cascade(speed='"shaking"'): "controllers.axis.speed = 'shaking': an algebraic loop",
    cascade(speed='"angle"'): "controllers.axis.speed = 'angle': it is a displacement, as what is",
    cascade(measure='"rate"'): "controllers.axis.speed: missing; 'rate' is no displacement",
    cascade(ti="0"): "controllers.axis.ti = 0: must be greater than zero, in s",
    transfer(numerator="[1, 2, 3]"): "controllers.axis.numerator = [1, 2, 3]: improper: it has the degree 2",
    transfer(denominator="[0, 1]"): "its first coefficient must not be 0",
    transfer(numerator="[]"): "numerator = []: give a list of numbers, descending powers of s",
    transfer(numerator='["a"]'): "controllers.axis.numerator.1 = 'a': is no number; text is not evaluated",
    transfer(limit="1", tracking="1"): "a transfer function has no integral that could follow",
    transfer(denominator="[1, -2000]", sample="1e-3"): "has a root at s = 2/sample = 2000 1/s",
    reference("{ stop = 1 }"): "references.path: gives no step, ramp, sine or profile; did you mean step?",
    reference("{ step = 1, time = 2 }"): "references.path.time = 2: unknown key; 'step' may hold step and at",
    reference("{ step = 1, at = -0.1 }"): "references.path.at = -0.1: must be zero or greater, in s",
    reference("{ sine = 1 }"): "references.path.frequency: missing; add frequency = 5.0",
    reference("{ step = '1 mm' }"): "references.path.step = '1 mm': 'mm' does not measure what rad does",
    reference("{ profile = [[1, 0], [1, 1]] }"): "references.path.profile.2.time = 1.0: the time must rise",
    reference("{ profile = [1, 2] }"): "give a list of points [time in s, value], as in",
    TEXT.replace('control = "axis"', 'control = "axes"'): "there is no controller 'axes'; did you mean axis?",
    TEXT.replace('control = "axis"', "control = 1"): 'name a controller, as in { control = "axis" }',
}


@pytest.mark.parametrize(("text", "sentence"), WRONG.items(), ids=range(len(WRONG)))
def test_what_will_not_do_is_told(text: str, sentence: str) -> None:
    with pytest.raises(MechanismError) as raised:
        Mechanism.from_toml_text(text)
    assert sentence in str(raised.value)


@pytest.mark.parametrize(
    "text",
    [
        axis(ki="1", limit="1", tracking="inf"),
        axis(ki="1", limit="1", tracking='"inf"'),
        axis(measure='"pull"', delay="1e-3", pade="2"),
        axis(measure='"torque"', sample="1e-3", delay='"2 ms"'),
        cascade(measure='"rate"', speed='"way"', kp="1", kv='"2 N"', ti="1", limit="1"),
        cascade(measure='"way"', kp='"3 s^-1"', kv="1", speed='"difference"', sample="1e-3"),
        transfer(numerator="[0, 1, 2]", limit='"1 N"', acts='["ground", "rack"]'),
        reference("{ ramp = '20 rpm', at = '1 s' }"),
        reference("{ sine = 1, frequency = '3 Hz', phase = '90 deg' }"),
        reference("{ profile = [[0, '2 deg'], ['1 s', 3]] }"),
    ],
)
def test_files_and_places_keep_what_they_hold(text: str) -> None:
    mechanism = Mechanism.from_toml_text(text)
    again = Mechanism.from_toml_text(mechanism.to_toml())
    assert again == mechanism
    assert hash(again) == hash(mechanism)
    for place in mechanism.places:
        if not place.startswith(("controllers", "references")):
            continue
        value = mechanism.value(place)
        if value and not place.endswith("tracking"):
            assert mechanism.with_value(place, 1.01 * value).value(place) == 1.01 * value
        assert mechanism.with_value(place, value).value(place) == value
    axis = mechanism.controllers["axis"]
    delays = axis.sample is not None or axis.pade is not None
    assert ("controllers.axis.delay" in mechanism.places) == delays


def test_units_follow_what_is_measured_and_what_acts() -> None:
    text = cascade(measure='"way"', speed='"rate"', kp="1", kv="1", ti="1", limit="1", reference='"path"')
    mechanism = Mechanism.from_toml_text(f"{text}[references]\npath = {{ ramp = 1 }}\n")
    expected = {"kp": "rad/s/m", "kv": "N m s/rad", "limit": "N m", "feedforward": "rad/m", "ti": "s"}
    for key, unit in expected.items():
        assert mechanism.places[f"controllers.axis.{key}"] == unit
    assert mechanism.places["references.path.ramp"] == "m/s"
    assert mechanism.output_units["torque"] == "N m"
    assert mechanism.value("controllers.axis.tracking") == 1.0


def test_open_numbers_are_named_with_their_place() -> None:
    with pytest.raises(MechanismError, match=r"axis\.kp = '1 N m/rad\.\.2 N m/rad': this is a range"):
        Mechanism.from_toml_text(axis(kp='"1 N m/rad..2 N m/rad"'))


def test_controllers_in_python() -> None:
    parts = {
        "bodies": {"slide": Body(1.0)},
        "links": {"mount": Link(("ground", "slide"), 1.0)},
        "outputs": {"way": Output({"slide": 1}), "u": Output(kind=OutputKind.CONTROL, part="lead")},
    }
    of = control.tf([1, 2], [1, 3, 4])
    controllers = {
        "lead": TransferController.of_system(of, measure="way", acts=("ground", "slide"), reference="step"),
        "pid": Pid(measure="way", acts=["ground", "slide"], kp=1, ki=2, limit=3),
        "speed": Cascade(measure="way", acts=("slide", "ground"), kp=1, kv=2, ti=0.5, reference="sine"),
    }
    references = {
        "step": StepReference(1),
        "ramp": RampReference(0.5, 1),
        "sine": SineReference(1, 5),
        "profile": ProfileReference([(0, 1), (1, 2)]),
    }
    mechanism = Mechanism(**parts, controllers=controllers, references=references)
    lead, pid = mechanism.controllers["lead"], mechanism.controllers["pid"]
    assert isinstance(lead, TransferController)
    assert (lead.numerator, lead.denominator) == ((1.0, 2.0), (1.0, 3.0, 4.0))
    assert (pid.acts, pid.tracking_time) == (("ground", "slide"), 0.5)
    assert mechanism.with_value("controllers.pid.tracking", math.inf).controllers["pid"].tracking == math.inf
    assert Mechanism.from_toml_text(mechanism.to_toml()) == mechanism
    with pytest.raises(MechanismError, match=r"controllers\.lead = .*: give one of the controllers"):
        Mechanism(**parts, controllers={"lead": {"kind": "pid"}})


@pytest.mark.parametrize(
    ("text", "law"),
    [
        (
            axis(kp="2", ki="-3", kd="4", filter_time="1e-6", limit="5", tracking="2"),
            (
                r"\dot I = (-3)\,e + \frac{1}{2}\,(\operatorname{sat}(w) - w)",
                r"w = 2\,e + I + 4\,\frac{e - z}{1 \cdot 10^{-6}}",
                r"\operatorname{sat}(w) = \max(-5, \min(5, w))",
            ),
        ),
        (
            cascade(kp="2", kv="3", ti="4", feedforward="5"),
            (r"f = 2\,e + 5\,\dot r - v", r"\dot I = \frac{3}{4}\,f"),
        ),
        (
            transfer(numerator="[1, 0, 2]", denominator="[3, 4, 5]"),
            (r"\frac{1\,s^{2} + 2}{3\,s^{2} + 4\,s + 5}",),
        ),
        (
            axis(ki="2", sample="1e-3", delay="2e-3"),
            (r"w_k = I_{k-1} + 2\,h\,e_k", r"\text{for } t_k + 0.002 \le t < t_{k+1} + 0.002"),
        ),
    ],
)
def test_laws_are_told_with_the_equations(text: str, law: tuple[str, ...]) -> None:
    from trimmer.code_generation import derive_mechanism_sources

    found = derive_mechanism_sources(Mechanism.from_toml_text(text))
    assert all(line in found.latex for line in (*law, r"\section{Controller: axis}"))
    # On the rack and the slide no other force is given.
    names: dict[str, object] = {}
    exec(found.module, names)
    directions = names["given_force_directions"]
    assert callable(directions)
    assert np.array(directions(1, 2, 3, 4)).tolist() == [[1.0], [0.0]]


def test_both_ends_take_the_force_in_the_equations() -> None:
    from trimmer.code_generation import derive_mechanism_sources

    text = axis(kp="1", acts='["rack", "slide"]')
    names: dict[str, object] = {}
    exec(derive_mechanism_sources(Mechanism.from_toml_text(text)).module, names)
    directions = names["given_force_directions"]
    assert callable(directions)
    assert np.array(directions(1, 2, 0.3, 4)).tolist() == [[-0.3], [1.0]]


def test_a_number_that_is_not_given_is_to_be_written_first() -> None:
    with pytest.raises(MechanismError, match=r"controllers\.axis\.sample is not given; write it into"):
        Mechanism.from_toml_text(axis(kp="1")).with_value("controllers.axis.sample", 1e-3)


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
        ('kind = "transfer"\nnumerator = [0]\ndenominator = [1.0]', "never acts: all of its numerator is 0"),
    ],
)
def test_what_never_acts_is_told(kind: str, told: str) -> None:
    mechanism = Mechanism.from_toml_text(MACHINE.replace("KIND", kind))
    assert list(idle_controllers(mechanism.controllers)) == ([f"controllers.axis {told}"] if told else [])
