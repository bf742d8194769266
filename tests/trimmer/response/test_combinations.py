"""Lines of a torus are named by the two frequencies of which they are sums."""

import math

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import example
from trimmer import MotionKind, peaks, respond
from trimmer.command_line.mechanisms.respond_text import as_text
from trimmer.response.results.response_json import response_json
from trimmer.response.statistics.combinations import sums_of
from trimmer.spectra import amplitude_spectrum

GOLDEN = (math.sqrt(5) - 1) / 2
DRIVE, OWN, SECONDS = 50.0, 50.0 * GOLDEN, 4.0


def test_lines_of_a_sampled_product_get_the_multiples_that_made_it() -> None:
    times = np.arange(8192) * SECONDS / 8192
    first, second = 2 * np.pi * DRIVE * times, 2 * np.pi * OWN * times
    made = {(1, 0): 1.0, (0, 1): 0.4, (1, 1): 0.2, (2, -1): 0.1, (3, -2): 0.05, (-1, 2): 0.03}
    series = sum(size * np.cos(i * first + j * second) for (i, j), size in made.items())
    lines = [(p.frequency, p.amplitude) for p in peaks(amplitude_spectrum(series, 8192 / SECONDS), 6)]
    own, names = sums_of(lines, DRIVE, 1 / SECONDS)
    assert own == pytest.approx(OWN, rel=1e-4)
    for (frequency, size), name in zip(lines, names, strict=True):
        assert frequency == pytest.approx(name[0] * DRIVE + name[1] * OWN, abs=0.02)
        assert size == pytest.approx(made[name], rel=0.05)
    assert set(names) == set(made)


def test_multiples_of_the_drive_alone_have_no_second_frequency() -> None:
    assert sums_of([(50.0, 1.0), (150.0, 0.1)], 50.0, 0.25) == (None, ((1, 0), (3, 0)))


def test_what_is_no_sum_is_not_named() -> None:
    found = sums_of([(50.0, 1.0), (31.0, 0.5), (39.7, 0.1)], 50.0, 0.01)
    assert found == (31.0, ((1, 0), (0, 1), None))


def test_a_torus_of_a_machine_tells_its_second_frequency() -> None:
    response = respond(example("second-play"), most_periods=100)
    assert response.motion.kind is MotionKind.TORUS
    drive, text = response.mechanism.frequency, as_text(response)
    for name, found in response_json(response)["outputs"].items():
        if (own := found["own_frequency"]) is None:
            assert found["multiples"] == [[round(each / drive), 0] for each, _ in found["peaks"]]
            continue
        assert f"lines of {name} at i x {drive:.6g} Hz, the drive, + j x {own:.6g} Hz: " in text
        assert [0, 1] in found["multiples"]
        for (frequency, _), name_of in zip(found["peaks"], found["multiples"], strict=True):
            if name_of is not None:
                assert frequency == pytest.approx(name_of[0] * drive + name_of[1] * own, rel=1e-3)
