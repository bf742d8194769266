"""All results of the linear model for one trimmer and one output, collected in one record."""

from dataclasses import dataclass

import control

from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, Displacement
from trimmer.linear.crossings import RealAxisCrossing, gain_crossings, real_axis_crossings
from trimmer.linear.extrema import Extremum, antiresonances, resonance_peaks
from trimmer.linear.frequency_response import UnsupportedSystemError
from trimmer.linear.low_pass import asymptotic_roll_off, bandwidth, bandwidth_crossings
from trimmer.linear.model import InputChannels, transfer_function
from trimmer.linear.modes import Mode, modes
from trimmer.linear.nyquist import PointOnLocusError, encirclements
from trimmer.linear.zero_pole_gain import ZeroPoleGain
from trimmer.parameters import TrimmerParameters
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Table, attributes

CRITICAL_POINT = -1.0  # The point of the Nyquist criterion for a loop 1 + G = 0


@dataclass(frozen=True)
class LowPass:
    """Low-pass behaviour relative to the gain at zero frequency.

    Attributes:
        bandwidth: Lowest frequency at which |G| falls 3 dB below that gain, rad/s; infinite if it never does.
        crossings: All frequencies at which |G| crosses that level, rad/s, rising.
    """

    bandwidth: float
    crossings: tuple[float, ...]


@dataclass(frozen=True, repr=False)
class LinearSummary(Tabular, Drawn):
    """Results of the linear model from pin displacement (m) to one output (m).

    ``plot`` draws |G| in dB over frequency, Hz, with its peaks and dips.

    Attributes:
        parameters: The trimmer.
        output: The output.
        channels: The inputs that the pin acts through.
        modes: Modes of the trimmer by rising natural frequency.
        factored: Gain, zeros and poles of G, rad/s.
        gain_crossings: Frequencies where |G| is 1, rad/s, rising.
        real_axis_crossings: Where G is real, by rising frequency.
        low_pass: Bandwidth; None where the gain at zero frequency is zero or infinite, so that there is none.
        peaks: Local maxima of |G| by rising frequency.
        antiresonances: Local minima of |G| by rising frequency.
        roll_off: Slope of |G| towards infinite frequency, dB per decade.
        encirclements: Clockwise encirclements of -1 by the Nyquist locus; None where it passes through -1.
    """

    parameters: TrimmerParameters
    output: Displacement
    channels: InputChannels
    modes: tuple[Mode, ...]
    factored: ZeroPoleGain
    gain_crossings: tuple[float, ...]
    real_axis_crossings: tuple[RealAxisCrossing, ...]
    low_pass: LowPass | None
    peaks: tuple[Extremum, ...]
    antiresonances: tuple[Extremum, ...]
    roll_off: float
    encirclements: int | None

    def _told(self) -> str:
        found = (counted(len(self.modes), "mode"), counted(len(self.peaks), "peak"))
        return f"output {self.output.label}, {', '.join(found)}, roll-off {self.roll_off:.4g} dB per decade"

    def _table(self) -> Table:
        columns = attributes(
            frequency="Hz", omega_natural="rad/s", omega_damped="rad/s", damping_ratio="", eigenvalue="1/s"
        )
        return Table("Modes", self.modes, columns)


def summarise(
    parameters: TrimmerParameters,
    output: Displacement | str = CUTTER_RELATIVE_TO_GUARD,
    channels: InputChannels | str = InputChannels.DISPLACEMENT_AND_VELOCITY,
) -> LinearSummary:
    """Analyse the transfer function from pin displacement to an output.

    Output and channels are chosen as in ``transfer_function``, also by their words.

    Raises:
        ChoiceError: if there are no such channels.
        DisplacementError: if the output is no displacement.
        UnsupportedSystemError: if the pin does not reach the output, so that G = 0.
        ParameterError: if the parameters are so far apart that the coefficients overflow.
    """
    output, channels = Displacement.parse(output), InputChannels.chosen(channels, "channels")
    system = transfer_function(parameters, output, channels)
    return LinearSummary(
        parameters=parameters,
        output=output,
        channels=channels,
        modes=modes(parameters),
        factored=ZeroPoleGain.of(system),
        gain_crossings=gain_crossings(system),
        real_axis_crossings=real_axis_crossings(system),
        low_pass=_low_pass(system),
        peaks=resonance_peaks(system),
        antiresonances=antiresonances(system),
        roll_off=asymptotic_roll_off(system),
        encirclements=_encirclements(system),
    )


def _low_pass(system: control.TransferFunction) -> LowPass | None:
    try:
        return LowPass(bandwidth(system), bandwidth_crossings(system))
    except UnsupportedSystemError:
        return None


def _encirclements(system: control.TransferFunction) -> int | None:
    try:
        return encirclements(system, CRITICAL_POINT)
    except PointOnLocusError:
        return None
