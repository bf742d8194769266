"""Records of exact orbits with noise, whose numbers are known."""

import numpy as np

from trimmer import Mechanism, Signal, respond
from trimmer.motion.signals import along, rate

RATE = 10_000.0
BEGIN = 0.00123  # Time in the drive's period at which records begin, s
UNITS = ("m", "m/s", "m/s²")


def trimmer(**numbers: float) -> Mechanism:
    mechanism = Mechanism.from_toml("examples/thesis-play.toml").with_value("frictions.blade.force", 1.0)
    for place, value in numbers.items():
        mechanism = mechanism.with_value(place, value)
    return mechanism


def exact(
    mechanism: Mechanism, output: str, samples: int, derivatives: int = 0, sample_rate: float = RATE
) -> np.ndarray:
    """Sample an output from the states of its orbit: no Fourier series, which the fit rests on."""
    orbit = respond(mechanism).motion.orbit
    assert orbit is not None
    course = orbit.course
    signal = orbit.flow.outputs[output].signal
    for _ in range(derivatives):
        signal = rate(course.modes, signal)
    times = (BEGIN + np.arange(samples) / sample_rate) % course.duration
    order = np.argsort(times)
    rows = np.searchsorted(course.log.start, times[order], side="right") - 1
    values = np.empty(samples)
    values[order] = along(course, signal, rows, course.states(times[order]))
    return values


def record(
    mechanism: Mechanism,
    noise: float,
    seed: int = 0,
    *,
    output: str = "stroke",
    samples: int = 4000,
    derivatives: int = 0,
    sample_rate: float = RATE,
) -> Signal:
    values = exact(mechanism, output, samples, derivatives, sample_rate)
    values = values + noise * np.random.default_rng(seed).normal(size=samples)
    return Signal(values, sample_rate, output, UNITS[derivatives])
