"""Waves and constant of a pin or a force, from the definition: Fourier sums of a waveform, term by term."""

import math

from trimmer import Force, Mechanism, Pin


def constant(part: Pin | Force) -> float:
    own = part.offset if isinstance(part, Pin) else part.constant
    return own + math.fsum(part.waveform or ()) / len(part.waveform or (1,))


def faster(mechanism: Mechanism, part: Pin | Force) -> float:
    """By what the drive of a part is faster than the frequency."""
    return 1.0 if part.drive is None else mechanism.drives[part.drive] / mechanism.frequency


def waves_in(mechanism: Mechanism, part: Pin | Force) -> list[tuple[float, float, float]]:
    """The same of a part of a mechanism, in orders of its frequency."""
    ratio = faster(mechanism, part)
    omega = 2 * math.pi * (mechanism.frequency or 0.0) * ratio
    return [(ratio * order, *other) for order, *other in waves(part, omega)]


def waves(part: Pin | Force, omega: float) -> list[tuple[int, float, float]]:
    """Order, amplitude and phase of each wave amplitude sin(order omega t + phase)."""
    amplitude = part.amplitude
    if isinstance(part, Force):
        amplitude += part.unbalance * (part.order * omega) ** 2
    found = [(part.order, amplitude, part.phase), *(part.harmonics or ())]
    samples = part.waveform or ()
    highest = part.orders or min(20, (len(samples) - 1) // 2)
    for order in range(1, highest + 1 if samples else 0):
        turns = [2 * math.pi * order * place / len(samples) for place in range(len(samples))]
        both = [
            2 / len(samples) * math.fsum(f(turn) * value for turn, value in zip(turns, samples, strict=True))
            for f in (math.sin, math.cos)
        ]
        found.append((order, math.hypot(*both), math.atan2(both[1], both[0])))
    return [(int(order), size, phase) for order, size, phase in found if size]
