"""What is told of the waveforms of a mechanism, which are cut off at their highest orders."""

from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.waves import left_out


def waveforms_left_out(mechanism: Mechanism) -> dict[str, float]:
    """Return that share of each waveform of a mechanism, by the place of its part."""
    return {
        place_text((section, name)): left_out(part)
        for section in ("pins", "forces")
        for name, part in getattr(mechanism, section).items()
        if part.waveform
    }


def told_of_waveforms(mechanism: Mechanism) -> list[str]:
    """Return a sentence for each waveform of a mechanism."""
    return [
        f"The waveform of {place} is cut off at its highest order: the rms of what is left out is {share:.3g}"
        " of that of its samples about their mean."
        for place, share in waveforms_left_out(mechanism).items()
    ]
