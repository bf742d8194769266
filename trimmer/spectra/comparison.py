"""A measured motion beside a simulated one that repeats: harmonics, and waveforms aligned in time."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trimmer.arguments import require_instance, whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Shown, Tabular, counted
from trimmer.showing.table import Table, arrays
from trimmer.signals.quantity import MotionQuantity, quantity_of
from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.classification import require_positive
from trimmer.spectra.harmonics import HarmonicFit, fit_harmonics
from trimmer.spectra.peaks import peaks
from trimmer.spectra.spectrum import amplitude_spectrum
from trimmer.spectra.window import Window

NEAR = 0.03  # How far from that of the simulation the frequency of the drive is looked for, relative

_POINTS_PER_LINE = 32
_HANN_LOSS = math.sqrt(1.5)
_BETTER = 0.8
_EXPLAINED = 0.5


@dataclass(frozen=True, eq=False, repr=False)
class SimulatedLines(Shown):
    """The lines of a simulated motion that repeats.

    Attributes:
        displacement: Complex amplitudes c of Re(c exp(2 pi j p f t / k)), p = 1, 2, ..., m, shape (n,).
        frequency: Frequency f of the drive, Hz; without a drive that of the motion.
        period_count: Drive periods k after which it repeats.
        unit: What the amplitudes are in, SI: that of a displacement, velocity or acceleration, or another.
        by_itself: Whether there is no drive. Then the measured frequency may be far from the simulated one,
            and is looked for about the largest peak.
    """

    displacement: Complexes
    frequency: float
    period_count: int = 1
    unit: str = "m"
    by_itself: bool = False

    def __post_init__(self) -> None:
        lines: NDArray[Any]
        try:
            lines = np.asarray(self.displacement)
        except ValueError:  # nested lists of unequal length
            lines = np.array(None)
        if lines.ndim != 1 or lines.size == 0 or lines.dtype.kind not in "fc" or not np.isfinite(lines).all():
            raise SignalError("displacement must be finite complex amplitudes in one dimension, at least one")
        object.__setattr__(self, "displacement", lines.astype(np.complex128))
        require_positive("frequency", self.frequency)
        whole_number("period_count", self.period_count, 1)

    def _told(self) -> str:
        lines = counted(np.asarray(self.displacement).size, "line")
        return f"{lines} at 1/{self.period_count} of {self.frequency:.9g} Hz"


@dataclass(frozen=True, eq=False, repr=False)
class MotionComparison(Tabular, Drawn):
    """A measured and a simulated motion, line by line.

    ``plot`` draws the measured spectrum, its lines and the simulated ones over frequency, Hz.

    Attributes:
        signal: The measured motion, SI.
        frequency: Frequency of the drive in the measurement, Hz.
        found: Whether that was found in the measurement; else it was given.
        simulated_frequency: Frequency of the drive in the simulation, Hz.
        period_count: Drive periods k after which the simulation repeats.
        measured: Complex amplitudes at p/k of the drive, p = 1, 2, ..., with t = 0 at the first sample, in
            the unit of the signal, shape (n,).
        simulated: The same of the simulation, in the quantity of the signal and shifted in time, shape (n,).
        uncertainty: Standard deviation of a measured amplitude, if what the lines leave is white noise.
        shift: By how much later the simulation begins than the measurement, s, in its own period.
        inverted_residual: The residual if the measurement had the opposite sign.
        rest: Root mean square of what the lines leave of the measurement.
    """

    signal: Signal
    frequency: float
    found: bool
    simulated_frequency: float
    period_count: int
    measured: Complexes
    simulated: Complexes
    uncertainty: float
    shift: float
    inverted_residual: float
    rest: float

    @property
    def period(self) -> float:
        """Time after which the simulation repeats, at the measured frequency, s."""
        return self.period_count / self.frequency

    @property
    def frequencies(self) -> Reals:
        """Frequency of each line in the measurement, Hz, shape (n,)."""
        return np.asarray(np.arange(1, self.measured.size + 1) / self.period)

    @property
    def decibels(self) -> Reals:
        """Measured over simulated amplitude, dB, shape (n,)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(20.0 * np.log10(np.abs(self.measured) / np.abs(self.simulated)))

    @property
    def phase_differences(self) -> Reals:
        """Phase of the measured line less that of the simulated one, rad, shape (n,)."""
        return np.asarray(np.angle(self.measured * self.simulated.conj()))

    @property
    def residual(self) -> float:
        """Root mean square of the difference of the lines, over that of the measured ones."""
        return _residual(self.measured, self.simulated)

    @property
    def opposite(self) -> bool:
        """Whether the opposite sign of the measurement would fit clearly better."""
        return self.inverted_residual < _BETTER * self.residual

    def _told(self) -> str:
        lines = counted(self.measured.size, "line")
        return f"{lines} at {self.frequency:.9g} Hz, difference {self.residual:.3%} rms"

    def _table(self) -> Table:
        unit = self.signal.unit
        columns = arrays(
            frequency=("Hz", self.frequencies),
            measured=(unit, np.abs(self.measured)),
            simulated=(unit, np.abs(self.simulated)),
            decibels=("dB", self.decibels),
            phase_difference=("rad", self.phase_differences),
        )
        return Table("Lines", range(self.measured.size), columns)

    def waveforms(self, points: int = 400) -> tuple[Reals, Reals, Reals]:
        """Return times from the first sample, s, and the lines of both added up over a period, (points,)."""
        times = np.asarray(np.arange(points) * (self.period / points))
        turned = np.exp(2j * np.pi * np.outer(self.frequencies, times))
        return times, (self.measured @ turned).real, (self.simulated @ turned).real


def compare_motions(
    signal: Signal, simulated: SimulatedLines, drive_frequency: float | None = None
) -> MotionComparison:
    """Fit the lines of a simulation to a measurement, and shift the simulation so that both agree best.

    The simulation is compared in the quantity that was measured: its lines are multiplied by (j omega)^n.
    When a measurement begins in the period of its drive is not known; so the shift is that of the least
    squares of the difference, and phases are told against it. Lines are compared as far as the measurement
    is to be trusted.

    Args:
        signal: The measured displacement, velocity or acceleration.
        simulated: Lines of the simulated displacement, or of another signal.
        drive_frequency: Frequency of the drive in the measurement, Hz; looked for near that of the simulation
            if not given.

    Raises:
        SignalError: if the signal is no motion, no line is near the frequency of the drive, or the record is
            too short to part the lines.
        WrongTypeError: if an argument is of another type.
    """
    require_instance("signal", signal, Signal, "a trimmer.Signal")
    require_instance("simulated", simulated, SimulatedLines, "a trimmer.spectra.SimulatedLines")
    derivatives = _derivatives(signal, simulated)
    measured = signal.in_si()
    found = drive_frequency is None
    if drive_frequency is not None:
        require_positive("frequency of the drive", drive_frequency)
    frequency = found_frequency(measured, simulated) if drive_frequency is None else float(drive_frequency)
    fit = _fit(measured, simulated, frequency)
    orders = np.arange(1, fit.coefficients.size + 1)
    omega = 2 * np.pi * frequency / simulated.period_count * orders
    lines = simulated.displacement[: orders.size] * (1j * omega) ** derivatives
    angle, _ = _alignment(fit.coefficients, lines)
    _, opposite = _alignment(-fit.coefficients, lines)
    return MotionComparison(
        signal=measured,
        frequency=frequency,
        found=found,
        simulated_frequency=simulated.frequency,
        period_count=simulated.period_count,
        measured=fit.coefficients,
        simulated=np.asarray(lines * np.exp(1j * orders * angle)),
        uncertainty=_HANN_LOSS * math.sqrt(2.0 / measured.values.size) * fit.residual,
        shift=(-angle % (2 * np.pi)) / (2 * np.pi) * simulated.period_count / frequency,
        inverted_residual=opposite,
        rest=fit.residual,
    )


def _derivatives(signal: Signal, simulated: SimulatedLines) -> int:
    """Return how often the simulated lines are differentiated to be what was measured."""
    quantity, own = signal.quantity, quantity_of(simulated.unit)
    if own is MotionQuantity.OTHER:
        if signal.unit == simulated.unit:
            return 0
        raise SignalError(
            f"{signal.name}: the output is in {simulated.unit}, and the signal in {signal.unit!r}; give it "
            f"in {simulated.unit} (--unit)"
        )
    if quantity is MotionQuantity.OTHER:
        raise SignalError(
            f"{signal.name}: the unit {signal.unit!r} does not tell whether it is a displacement, a "
            "velocity or an acceleration, so it is compared with no motion; say what it is (--unit)"
        )
    return quantity.derivatives - own.derivatives


def sought(by_itself: bool) -> tuple[str, str]:
    """Return what is looked for in a measurement, and what its frequency would say, in words."""
    return ("vibration", "it vibrates") if by_itself else ("drive", "it was driven")


def found_frequency(signal: Signal, simulated: SimulatedLines) -> float:
    """Find the drive: the largest line near its harmonics, and what explains most beside it.

    Without a drive it is looked for about the largest peak, over the order at which that is nearest to
    the frequency of the simulation.
    """
    what, how = sought(simulated.by_itself)
    spectrum, about = amplitude_spectrum(signal.values, signal.sample_rate), simulated.frequency
    lines = [peak.frequency for peak in peaks(spectrum, 20) if peak.frequency in signal.trusted]
    if simulated.by_itself and lines:
        about = lines[0] / max(round(lines[0] / about), 1)
    near = [
        line / order
        for line in lines
        if (order := round(line / about)) and abs(line / order - about) <= NEAR * about
    ]
    if not near:
        raise SignalError(
            f"no line of the measurement is within {100 * NEAR:g} % of a harmonic of the {what} at "
            f"{about:g} Hz; say at which frequency {how} (--drive)"
        )
    from scipy.optimize import minimize_scalar

    half = 0.5 * spectrum.bin_width
    best = minimize_scalar(
        lambda tried: _fit(signal, simulated, tried).residual,
        bounds=(near[0] - half, near[0] + half),
        method="bounded",
        options={"xatol": 1e-5 * spectrum.bin_width},
    )
    frequency = float(best.x)
    explained = _fit(signal, simulated, frequency).explained
    if explained < _EXPLAINED:
        raise SignalError(
            f"multiples of {frequency:.6g} Hz, the {what} that is nearest to the {simulated.frequency:g} Hz "
            f"of the simulation, explain only {100 * explained:.3g} % of the measurement's variance; say "
            f"at which frequency {how} (--drive)"
        )
    return frequency


def _fit(signal: Signal, simulated: SimulatedLines, frequency: float) -> HarmonicFit:
    """Fit as many lines as there are in the simulation, or fewer if the measurement does not show them."""
    step = frequency / simulated.period_count
    rate, samples = signal.sample_rate, signal.values.size
    window = Window.HANN
    highest = min(0.5 * rate * (1.0 - window.half_width / samples), signal.trusted.highest)
    count = min(simulated.displacement.size, math.floor(highest / step))
    if count < simulated.period_count:
        raise SignalError(
            f"the measurement is {signal.trusted.sentence}, and samples at {rate:g} Hz show no "
            f"{sought(simulated.by_itself)[0]} at {frequency:g} Hz"
        )
    return fit_harmonics(signal.values, rate, step, count, window)


def _alignment(measured: Complexes, simulated: Complexes) -> tuple[float, float]:
    """Return the angle of the first line by which the simulation is turned, rad, and the residual there."""
    angle = best_angle(measured * simulated.conj())
    orders = np.arange(1, measured.size + 1)
    return angle, _residual(measured, simulated * np.exp(1j * orders * angle))


def best_angle(products: Complexes) -> float:
    """Return the angle of the first line by which simulated lines are to be turned to agree best, rad.

    The sum of measured times conjugate simulated lines, (n,), over all angles is a Fourier series; its
    largest value is searched on a grid finer than its fastest term, and from there by Newton's method.
    """
    orders = np.arange(1, products.size + 1)
    points = _POINTS_PER_LINE * products.size
    grid = np.arange(points) * (2 * np.pi / points)
    series = np.zeros(points, np.complex128)
    series[orders] = products
    angle = float(grid[int(np.argmax(np.fft.fft(series).real))])
    for _ in range(8):
        turned = products * np.exp(-1j * orders * angle)
        slope, bend = float((turned * -1j * orders).real.sum()), float((-turned * orders**2).real.sum())
        if bend >= 0.0:
            break
        angle -= slope / bend
    return angle


def _residual(measured: Complexes, simulated: Complexes) -> float:
    size = float(np.linalg.norm(measured))
    return float(np.linalg.norm(measured - simulated)) / size if size else math.inf
