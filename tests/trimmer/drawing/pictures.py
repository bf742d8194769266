"""Pictures of results, and what Matplotlib says of them, in words.

``python -m tests.trimmer.drawing.pictures`` writes ``pictures.txt`` anew; its differences are read.
"""

import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import control
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import Collection, QuadMesh
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch

import trimmer
from tests.trimmer import results
from tests.trimmer.maps.machines import impact_oscillator
from tests.trimmer.uncertainty.test_samples import TEXT
from trimmer import SerialRunner, sample
from trimmer.design.analysis.linear import all_drives, linear_states
from trimmer.drawing.frequency_response import summary_figure
from trimmer.drawing.locus import balance_figure
from trimmer.drawing.mechanisms.branch import branch_figure
from trimmer.drawing.mechanisms.linear import linear_figure
from trimmer.drawing.mechanisms.response import motion_figure, response_figure
from trimmer.drawing.mechanisms.scatter import sample_figure
from trimmer.drawing.mechanisms.step import step_figure
from trimmer.drawing.mechanisms.sweep import sweep_figure
from trimmer.drawing.signals.comparison import comparison_figure
from trimmer.drawing.signals.fit import fit_figure
from trimmer.uncertainty import Samples, SampleSettings
from trimmer.uncertainty.sample_file import sample_file_of_text

KEPT = Path(__file__).with_suffix(".txt")
FEW = 8  # Points up to which each is told
NOTHING = 1e-6  # Share of the largest coordinate below which a mean is rounding
VISCOUS = trimmer.ViscousBacklash(4e-5, 1e-3)
RELAY = trimmer.Relay(1.0)
SAMPLED = TEXT.replace("0.9", "1.41").replace('"links.spring.stiffness" = { normal = "5 %" }\n', "")


def new_axes() -> Axes:
    return Figure().add_subplot()


def lines(axes: Axes, label: str) -> list[Line2D]:
    return [each for each in axes.lines if each.get_label() == label]


def points(axes: Axes, label: str) -> np.ndarray:
    """The points of the one line with a label, (n, 2)."""
    (found,) = lines(axes, label)
    return np.asarray(found.get_xydata())


def legend(axes: Axes) -> list[str]:
    found = axes.get_legend()
    return [] if found is None else [text.get_text() for text in found.get_texts()]


@cache
def viscous() -> trimmer.HarmonicBalance:
    return trimmer.harmonic_balance(results.system(), VISCOUS)


@cache
def frozen() -> trimmer.HarmonicBalance:
    return trimmer.harmonic_balance(results.system(), VISCOUS, frozen_omega=4000.0)


@cache
def integrated() -> trimmer.HarmonicBalance:
    """1/(s (s + 1)^2) is -1/2 at 1 rad/s; -1/N of a relay of height 1 is -pi A/4, so A is 2/pi."""
    return trimmer.harmonic_balance(control.tf([1], [1, 2, 1, 0]), RELAY)


@cache
def calm() -> trimmer.HarmonicBalance:
    """Without a limit cycle."""
    return trimmer.harmonic_balance(control.tf([0.1], [1, 1]), trimmer.FrictionBacklash(1.0))


@cache
def peaks() -> trimmer.spectra.SpectrumAnalysis:
    """Lines of all origins, by falling amplitude."""
    times = np.arange(4000) / 4000.0
    frequencies = [100.0, 103.0, 200.0, 310.0, 400.0, 554.3, 600.0, 700.0, 800.0]
    values = sum(
        1e-3 / (number + 1) * np.sin(2 * np.pi * frequency * times)
        for number, frequency in enumerate(frequencies)
    )
    signal = trimmer.Signal(values, 4000.0, "x", "m")
    return trimmer.analyse_signal(signal, 100.0, [103.0], [554.3], closed_loop=True)


@cache
def dying() -> trimmer.spectra.SpectrumAnalysis:
    """Of a vibration that dies out."""
    times = np.arange(4000) / 4000.0
    signal = trimmer.Signal(np.exp(-5.0 * times) * np.sin(2 * np.pi * 200.0 * times), 4000.0)
    with warnings.catch_warnings(action="ignore"):  # it is no steady sine
        return trimmer.analyse_signal(signal)


@cache
def doubled() -> trimmer.FollowedBranch:
    """Over the period doubling of a published oscillator, 0.8843793 Hz, with the branch that parts there."""
    mechanism = trimmer.Mechanism.from_toml("examples/oscillator-stop.toml")
    settings = trimmer.FollowSettings(quiet=True, most_points=25, largest_step=0.05)
    return trimmer.follow(mechanism, "frequency", 0.87, 0.9, settings=settings)


@cache
def rubbing() -> trimmer.FollowedBranch:
    """A block on a belt, which moves by itself."""
    belt = trimmer.Mechanism.from_toml("examples/block-on-belt.toml")
    settings = trimmer.FollowSettings(quiet=True, most_points=3)
    return trimmer.follow(belt, "pins.belt.velocity", 0.2, 0.3, settings=settings)


@cache
def bare() -> trimmer.MechanismMotion:
    """Without outputs."""
    mechanism = replace(results.stopped().mechanism, outputs={})
    return trimmer.simulate(mechanism, 6.0, state={"mass": (12.0, 100.0)})


@cache
def shaving() -> trimmer.MechanismMotion:
    return trimmer.simulate(trimmer.Mechanism.from_toml("examples/foil-shaver.toml"), 0.02)


@cache
def thrown() -> trimmer.MechanismMotion:
    """Of a body that nothing drives."""
    return trimmer.simulate(trimmer.Mechanism.from_toml("examples/thrown-body.toml"), 0.5)


@cache
def shaken() -> trimmer.Mechanism:
    return trimmer.Mechanism.from_toml("examples/two-mass-stop.toml")


@cache
def two_masses() -> trimmer.Response:
    return trimmer.respond(shaken())


@cache
def stepped() -> trimmer.response.StepResponse:
    servo = trimmer.Mechanism.from_toml("examples/two-mass-servo.toml")
    return trimmer.response.step_response(servo, next(iter(servo.references)))


@cache
def swept() -> trimmer.maps.Sweep:
    """Up beyond the fold, and back, beside the branch."""
    ways = {"steps": 3, "periods": 60, "back": True, "branch": True, "quiet": True}
    return trimmer.maps.sweep(impact_oscillator(), "frequency", 1.1, 1.4, **ways)


@cache
def ringing() -> trimmer.Response:
    """Without damping, so that what it begins with never dies out."""
    mechanism = trimmer.Mechanism(
        {"mass": trimmer.Body(1.0)},
        frequency=0.3,
        links={"spring": trimmer.Link(("ground", "mass"), stiffness=1.0)},
        forces={"push": trimmer.Force("mass", amplitude=1.0)},
    )
    return trimmer.respond(mechanism)


@cache
def samples() -> Samples:
    file = sample_file_of_text(SAMPLED, "stop.toml")
    settings = SampleSettings(count=12, most_periods=60)
    return sample(file.subject, file.uncertainty, settings, targets=file.targets, runner=SerialRunner())


@cache
def measured(*gaps: float) -> trimmer.MotionMap:
    """A map over the frequency, in no order, and gaps, if there are any."""
    values = {"frequency": [1.3, 1.1, 1.2]} | ({"stops.wall.gap": [*gaps]} if gaps else {})
    keys = ["outputs.x.rms"] if gaps else []
    return trimmer.motion_map(impact_oscillator(), values, measures=keys, runner=SerialRunner(), quiet=True)


PLOTS: dict[str, Callable[..., Axes]] = {
    "HarmonicBalance": lambda ax=None: results.balance().plot(ax),
    "HarmonicBalance, near": lambda ax=None: results.balance().plot(ax, near=True),
    "HarmonicBalance, frozen": lambda ax=None: frozen().plot(ax),
    "HarmonicBalance, near none": lambda ax=None: calm().plot(ax, near=True),
    "Identification": lambda ax=None: results.identification().plot(ax),
    "FrictionBacklash": lambda ax=None: results.PLAY.plot(ax),
    "FrictionBacklash, locus": lambda ax=None: results.PLAY.plot_locus(ax),
    "FrictionBacklash, turned": lambda ax=None: (results.PLAY * -1.0).plot(ax),
    "InertiaBacklash": lambda ax=None: trimmer.InertiaBacklash(4e-5).plot(ax),
    "ViscousBacklash": lambda ax=None: VISCOUS.plot(ax, omega=4600.0),
    "ViscousBacklash, locus": lambda ax=None: VISCOUS.plot_locus(ax, omega=4600.0),
    "Relay": lambda ax=None: RELAY.plot(ax),
    "Relay, locus": lambda ax=None: RELAY.plot_locus(ax),
    "PeriodicOrbits": lambda ax=None: results.orbits().plot(ax),
    "PeriodicOrbit": lambda ax=None: results.orbits()[0].plot(ax),
    "Motion": lambda ax=None: results.driven().plot(ax),
    "LoopMotion": lambda ax=None: results.driven().plot(ax),
    "MechanismMotion": lambda ax=None: results.stopped().plot(ax),
    "MechanismMotion, bodies": lambda ax=None: bare().plot(ax),
    "MechanismMotion, many parts": lambda ax=None: shaving().plot(ax),
    "MechanismOrbit": lambda ax=None: results.forced().plot(ax),
    "Response": lambda ax=None: results.response().plot(ax),
    "FollowedBranch": lambda ax=None: results.branch().plot(ax),
    "FollowedBranch, of its own": lambda ax=None: rubbing().plot(ax),
    "MotionMap": lambda ax=None: results.motion_map().plot(ax),
    "MotionMap, stroke": lambda ax=None: measured().plot(ax),
    "MotionMap, measure": lambda ax=None: measured(10.0, 8.0).plot(ax, measure="outputs.x.rms", target=8.0),
    "MotionMap, one gap": lambda ax=None: measured(10.0).plot(ax, measure="outputs.x.rms", target=8.0),
    "Sweep": lambda ax=None: results.swept().plot(ax),
    "Basin": lambda ax=None: results.basin().plot(ax),
    "Samples": lambda ax=None: samples().plot(ax),
    "SpecialCurves": lambda ax=None: results.curves().plot(ax),
    "SpecialCurve": lambda ax=None: results.curves().curves[0].plot(ax),
    "Locus": lambda ax=None: results.locus().plot(ax),
    "LinearSummary": lambda ax=None: results.summary().plot(ax),
    "TimeResponse": lambda ax=None: results.time_response().plot(ax),
    "Signal": lambda ax=None: results.signal().plot(ax),
    "SpectrumAnalysis": lambda ax=None: results.analysis().plot(ax),
    "SpectrumAnalysis, peaks": lambda ax=None: peaks().plot(ax),
    "SpectrumAnalysis, dying": lambda ax=None: dying().plot(ax),
    "Spectrum": lambda ax=None: results.analysis().spectrum.plot(ax),
    "AveragedSpectrum": lambda ax=None: results.averaged().plot(ax),
    "MotionComparison": lambda ax=None: results.comparison().plot(ax),
    "HarmonicFit": lambda ax=None: results.analysis().harmonics.plot(ax),
    "Fit": lambda ax=None: results.fit().plot(ax),
}
"""A way to draw each kind of result."""
FIGURES: dict[str, Callable[[], Figure]] = {
    "limit-cycles": lambda: balance_figure(viscous()),
    "limit-cycles, integrated": lambda: balance_figure(integrated()),
    "limit-cycles, none": lambda: balance_figure(calm()),
    "linear": lambda: summary_figure(results.summary()),
    "linear, mechanism": lambda: linear_figure(shaken(), linear_states(shaken(), all_drives(shaken()))),
    "simulate": lambda: motion_figure(results.stopped()),
    "simulate, thrown": lambda: motion_figure(thrown()),
    "respond": lambda: response_figure(results.response()),
    "respond, two motions": lambda: response_figure(trimmer.respond(impact_oscillator(), starts=12)),
    "respond, two outputs": lambda: response_figure(two_masses()),
    "respond, torus": lambda: response_figure(ringing()),
    "follow": lambda: branch_figure(doubled()),
    "sweep": lambda: sweep_figure(swept()),
    "step": lambda: step_figure(stepped()),
    "sample": lambda: sample_figure(samples()),
    "overlay": lambda: comparison_figure(results.comparison()),
    "fit": lambda: fit_figure(results.fit()),
}
"""What ``--plot`` draws of several panels."""


def pictures() -> dict[str, Callable[[], Figure]]:
    """Return all pictures by their names."""
    return {
        name: lambda plot=plot: plot(Figure(figsize=(3.5, 3.2)).add_subplot()).figure
        for name, plot in PLOTS.items()
    } | FIGURES


def in_words(figure: Figure) -> str:
    """Say what is in a picture: axes, legends, and all that is drawn in data."""
    width, height = figure.get_size_inches()
    told = [f"{_number(width)} x {_number(height)} inches, {figure.get_suptitle()!r}"]
    for axes in figure.axes:
        told += [*_of_axes(axes), *(f"  {each}" for each in _of_data(axes))]
    return "\n".join(told)


def _of_axes(axes: Axes) -> Iterator[str]:
    if not axes.axison:
        yield "no axes"
        return
    for each, limits in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        grid = "with grid" if any(line.get_visible() for line in each.get_gridlines()[:1]) else "without grid"
        # How much room a logarithm leaves above depends on the least that is drawn, which may be rounding.
        shown = limits[:1] if (each.axis_name, each.get_scale()) == ("y", "log") else limits
        yield f"{each.axis_name}: {each.get_label_text()!r}, {each.get_scale()}, {_pair(shown)}, {grid}"
    if axes.get_title():
        yield f"title: {axes.get_title()!r}"
    if axes.get_legend() is not None:
        title = axes.get_legend().get_title().get_text()
        yield f"legend: {legend(axes)}{f', {title!r}' if title else ''}"


def _of_data(axes: Axes) -> Iterator[str]:
    for line in axes.lines:
        look = f"{to_hex(line.get_color())} {line.get_linestyle()} {line.get_marker()}"
        if line.get_marker() not in ("", "None"):
            full = line.get_fillstyle() != "none" and to_hex(line.get_markerfacecolor()) != "#ffffff"
            look += " full" if full else " open"
        yield f"line {_name(line)} {look}: {_places(line.get_xydata())}"
    for each in axes.collections:
        yield f"collection {_name(each)} {_colours(each)} {each.get_hatch()}: {_reached(each)}"
    for each in axes.patches:
        look = f"{to_hex(each.get_facecolor()) if each.get_fill() else 'hatching'} {each.get_hatch()}"
        path = each.get_path() if isinstance(each, PathPatch) else each.get_patch_transform()
        corners = path.vertices if isinstance(each, PathPatch) else path.transform([[0, 0], [1, 1]])
        yield f"patch {_name(each)} {look}: {_places(corners)}"
    for text in axes.texts:
        yield f"text {text.get_text()!r} at {_pair(text.xy)}, from {_pair(text.xyann)}"


def _name(artist: Artist) -> str:
    """Return the label of what has one; Matplotlib numbers the others."""
    label = str(artist.get_label())
    return "without a label" if label.startswith(("_child", "_nolegend_")) else repr(label)


def _colours(collection: Collection) -> list[str]:
    colours = collection.get_facecolor()
    return [to_hex(each) for each in (colours if len(colours) else collection.get_edgecolor())][:FEW]


def _reached(collection: Collection) -> str:
    if isinstance(collection, QuadMesh):
        corners, values = collection.get_coordinates(), np.ravel(collection.get_array())
        sides = _places(corners[0], 4), _places(corners[:, 0], 4)
        return f"{' and '.join(sides)}, in {collection.cmap.name} {_places(values[:, None])}"
    if len(collection.get_offsets()) > 1:
        return _places(collection.get_offsets())
    return "; ".join(_places(path.vertices, 4) for path in collection.get_paths()[:FEW])


def _places(places: np.ndarray, few: int = FEW) -> str:
    """Say all of few places; of many the first, the last, within what they lie, and their mean."""
    if len(places) <= few:
        return " ".join(map(_pair, places))
    seen = places[np.isfinite(places).all(axis=1)]
    within = [_pair((part.min(), part.max())) for part in seen.T]
    mean = np.where(abs(seen.mean(axis=0)) < NOTHING * abs(seen).max(axis=0), 0.0, seen.mean(axis=0))
    return f"{_pair(places[0])} ... {_pair(places[-1])}, within {' x '.join(within)}, mean {_pair(mean)}"


def _pair(numbers: Iterable[float]) -> str:
    return f"({', '.join(map(_number, numbers))})"


def _number(number: float) -> str:
    """Return five digits, and none of what is rounding."""
    return f"{0.0 if abs(number) < 1e-13 else number:.5g}"


def kept() -> dict[str, str]:
    """Return what is kept of each picture."""
    told = (each.partition("\n") for each in KEPT.read_text("utf-8").split("== ")[1:])
    return {name: words.strip() for name, _, words in told}


if __name__ == "__main__":
    told = (f"== {name}\n{in_words(make())}\n" for name, make in pictures().items())
    KEPT.write_text("\n".join(told), "utf-8")
