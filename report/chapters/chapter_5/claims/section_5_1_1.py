"""Claims of section 5.1.1: the time response of the linear trimmer (figure 5.1)."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LinearNumbers
from trimmer import linear_model, steady_state

SOURCE = "trimmer/time_domain.py"
SMALL_DEVIATION = 0.01


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_amplitude(evidence.numbers), _time_response(evidence.numbers))


def _settled(numbers: LinearNumbers, frequency: float) -> tuple[float, float]:
    """Return amplitude (m) and phase (rad) of the settled output at a frequency (Hz)."""
    settled = steady_state(numbers.displacement_only, 2 * math.pi * frequency, DRIVE_AMPLITUDE)
    return settled.amplitude, settled.phase


def _amplitude_part(numbers: LinearNumbers) -> Part:
    amplitude, _ = _settled(numbers, DRIVE_FREQUENCY)
    return Part(
        "amplitude of the settled output",
        PrintedDigits("0.0015", amplitude, "m"),
        Confirmation(
            "half of peak to peak of a simulation",
            CloseNumbers(numbers.start.settled_amplitude, amplitude, 1e-5),
        ),
    )


def _amplitude(numbers: LinearNumbers) -> Claim:
    amplitude, phase = _settled(numbers, DRIVE_FREQUENCY)
    slow, _ = _settled(numbers, 1.0)
    both = steady_state(numbers.both_channels, 2 * math.pi * DRIVE_FREQUENCY, DRIVE_AMPLITUDE)
    return Claim(
        id="txt-5.1.1-amplitude",
        parts=(_amplitude_part(numbers),),
        explanation=(
            f"At 100 Hz the gain is {amplitude / DRIVE_AMPLITUDE:.5f}, so the amplitudes agree to the "
            f"printed digits; the output lags by {-math.degrees(phase):.2f} degrees. That is a coincidence "
            f"of this frequency: a slow drive gives {100 * slow / DRIVE_AMPLITUDE:.1f} % of the pin's "
            "amplitude, and from there the gain rises towards the resonances. With the pin's velocity as "
            f"second input the gain is {both.amplitude / DRIVE_AMPLITUDE:.5f}."
        ),
        source=SOURCE,
    )


def _deviation(numbers: LinearNumbers) -> float:
    """Return the largest difference of output and pin in the first period from rest (m) by integration."""
    model = linear_model(numbers.parameters)[0, 0]
    state, drive, output = np.asarray(model.A), np.asarray(model.B)[:, 0], np.asarray(model.C)[0]
    omega, times = 2 * math.pi * DRIVE_FREQUENCY, np.linspace(0, 1 / DRIVE_FREQUENCY, 1001)
    run = solve_ivp(
        lambda time, x: state @ x + drive * (DRIVE_AMPLITUDE * math.sin(omega * time)),
        (0, times[-1]),
        np.zeros(drive.size),
        "DOP853",
        times,
        rtol=1e-9,
        atol=1e-12,
    )
    return float(np.abs(output @ run.y - DRIVE_AMPLITUDE * np.sin(omega * times)).max())


def _time_response(numbers: LinearNumbers) -> Claim:
    deviation = numbers.start.deviation
    _, phase = _settled(numbers, DRIVE_FREQUENCY)
    slowest = min(-mode.eigenvalue.real for mode in numbers.modes)
    return Claim(
        id="fig-5.1",
        parts=(
            _amplitude_part(numbers),
            Part(
                "from rest, first period",
                Assertion(
                    statement="the output follows the input precisely",
                    derived=deviation <= SMALL_DEVIATION * DRIVE_AMPLITUDE,
                    evidence=(
                        f"in the first period the output is up to {1e3 * deviation:.2f} mm away from the "
                        f"pin, {100 * deviation / DRIVE_AMPLITUDE:.0f} % of the amplitude"
                    ),
                    method=f"simulation from rest; asked for: {100 * SMALL_DEVIATION:.0f} % of the amplitude",
                ),
                Confirmation(
                    "SciPy's DOP853 over that period", CloseNumbers(_deviation(numbers), deviation, 1e-5)
                ),
            ),
        ),
        explanation=(
            "Read as the settled motion, the statement holds to the printed digits. Read as it stands, for "
            "the command that is quoted and its start from rest, it does not: the start excites the natural "
            f"modes, and the slowest of them decays with {slowest:.0f}/s, so it is visible for several "
            f"periods. After that a lag of {-math.degrees(phase):.2f} degrees is left."
        ),
        consequence=(
            "None on predictions. A spectrum of such a run has peaks at the natural frequencies that no "
            "nonlinearity caused, unless the start is cut off."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )
