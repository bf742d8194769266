"""Linear systems in the forms in which people have them, and stored and built again."""

import pickle
from typing import Any

import control
import numpy as np
import pytest
import scipy.signal

from trimmer import ClosedLoop, Drive, Feedback, OpenLoop, Saturation, harmonic_balance, simulate
from trimmer.linear import UnsupportedSystemError, ZeroPoleGain
from trimmer.linear.plant_forms import adopted_system
from trimmer.linear.stored_system import restored, stored

NUMERATOR, DENOMINATOR = [4.0], [1.0, 2.0, 1.0, 0.0]
ROOTS = ([], [-1.0, -1.0, 0.0], 4.0)
FORMS = {
    "tf": control.tf(NUMERATOR, DENOMINATOR),
    "lti": scipy.signal.lti(NUMERATOR, DENOMINATOR),
    "ss of SciPy": scipy.signal.StateSpace(*scipy.signal.tf2ss(NUMERATOR, DENOMINATOR)),
    "zpk of SciPy": scipy.signal.ZerosPolesGain(*ROOTS),
    "(num, den)": (NUMERATOR, DENOMINATOR),
    "(z, p, k)": ROOTS,
    "(A, B, C, D)": scipy.signal.tf2ss(NUMERATOR, DENOMINATOR),
}


@pytest.mark.parametrize("form", FORMS)
def test_every_form_of_a_system_has_the_same_prediction_and_the_same_motion(form: str) -> None:
    # 4/(s (s + 1)^2) with a saturation: phase -180 degrees at 1 rad/s, where |G| = 2 asks for N = 1/2.
    given, limit = FORMS[form], Saturation(1.0)
    for predicted in (harmonic_balance(given, limit), harmonic_balance(ClosedLoop(given, limit))):
        (cycle,) = predicted.limit_cycles
        assert predicted.success
        assert cycle.omega == pytest.approx(1.0, rel=1e-12)
        assert limit.describing_function(cycle.amplitude) == pytest.approx(0.5, rel=1e-12)
    loops = (OpenLoop(system, limit, Drive(2.0, frequency=1.0)) for system in (given, FORMS["tf"]))
    ours, known = (simulate(loop, 1.0).output(np.linspace(0.0, 1.0, 7)) for loop in loops)
    assert ours == pytest.approx(known, rel=1e-10, abs=1e-12)
    if isinstance(given, control.LTI):
        return
    assert Feedback(given, {"limit": -limit}).plant.input_labels == ["limit"]


@pytest.mark.parametrize(
    ("zeros", "poles", "gain"),
    [
        ([], [-1.0] * 8, 2.0),
        ([-1.0, -2 + 3j, -2 - 3j], [-1 + 4j, -1 - 4j, -3.0, -5.0, -7.0], 3.0),
        ([1j, -1j, 3j, -3j], [-1.0, -2.0, -3.0, -4.0], 1.0),
        ([0.0], [-1 + 1e3j, -1 - 1e3j], -2.0),
        ([], [], 3.0),
    ],
)
def test_zeros_and_poles_keep_their_digits(zeros: list[complex], poles: list[complex], gain: float) -> None:
    system = adopted_system((zeros, poles, gain))
    assert isinstance(system, control.StateSpace)
    s = 1j * np.geomspace(1e-2, 1e4, 60)
    products = [np.prod([s - each for each in roots] + [1.0 + 0.0 * s], axis=0) for roots in (zeros, poles)]
    assert system(s) == pytest.approx(gain * products[0] / products[1], rel=1e-11)
    if poles:
        found = ZeroPoleGain.of(system)
        # The companion matrix of (s + 1)^8 has its eigenvalues 1e-2 beside -1.
        assert sorted(found.poles, key=str) == pytest.approx(sorted(map(complex, poles), key=str), rel=1e-12)
        assert found.relative_degree == len(poles) - len(zeros)


REFUSED: dict[str, tuple[Any, str]] = {
    "five": ((1, 2, 3, 4, 5), r"a tuple of 5 is no system; tuples are \(num, den\)"),
    "no denominator": (([1], [0]), "makes no system .*zero denominator"),
    "shapes": (([[1]], [1], [1], [1, 2]), "makes no system .*D matrix"),
    "improper": (([1, 2], [1], 2.0), "more zeros than poles"),
    "no pair": (([], [-1 + 1j], 2.0), "the poles of the system must come in conjugate pairs; -1[+]1j has"),
    "other pair": (([], [-1 + 1j, -1 - 2j], 2.0), "the poles of the system must come in conjugate pairs"),
    "half a pair": (([-1 - 1j], [-1, -2], 2.0), "the zeros of the system .* -1-1j has none"),
    "not finite": (([], [np.nan], 2.0), "must be finite"),
    "sampled": (scipy.signal.dlti([1], [1, 1], dt=0.1), "dt = 0.1.* must be continuous in time"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_makes_no_system_is_refused(case: str) -> None:
    given, message = REFUSED[case]
    for refuse in (harmonic_balance, ClosedLoop):
        with pytest.raises(UnsupportedSystemError, match=message):
            refuse(given, Saturation(1.0))
    with pytest.raises(UnsupportedSystemError, match=message):
        Feedback(given, {"limit": Saturation(1.0)})


@pytest.mark.parametrize("dt", [0, 0.25, True, None])
def test_a_system_comes_back_with_its_names_and_with_states_that_nothing_reaches(dt: float | None) -> None:
    A, B = np.array([[-1.0, 2.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 0.0]]), [[1.0], [4.0], [0.0]]
    given = control.StateSpace(
        *(A, B, [[5.0, 6.0, 0.0], [7.0, 8.0, 0.0]], [[9.0], [10.0]], dt),
        remove_useless_states=False,
        name="by hand",
        states=["a", "b", "idle"],
        inputs=["force"],
        outputs=["left", "right"],
    )
    found = restored(pickle.loads(pickle.dumps(stored(given))))
    for name in "ABCD":
        assert getattr(found, name).tolist() == getattr(given, name).tolist()
    assert (found.dt, found.name) == (dt, "by hand")
    assert found.state_labels == ["a", "b", "idle"]
    assert (found.input_labels, found.output_labels) == (["force"], ["left", "right"])


def test_what_is_no_state_space_stays_as_it_is() -> None:
    for value in (control.tf([1.0], [1.0, 2.0]), 3.0, None):
        assert stored(value) is value
        assert restored(value) is value
