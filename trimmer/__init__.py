"""Vibration of a hair trimmer: its linear model, and what can be computed from it.

Names are imported from their modules when they are first used, so importing the package costs nothing:

    >>> from trimmer import TrimmerParameters, pin_model, resonance_peaks
    >>> peaks = resonance_peaks(pin_model(TrimmerParameters.thesis()))
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from trimmer.balance.errors import FrequencyRangeError as FrequencyRangeError
    from trimmer.balance.errors import LinearElementError as LinearElementError
    from trimmer.balance.errors import UndecidedWarning as UndecidedWarning
    from trimmer.balance.errors import UnsupportedElementError as UnsupportedElementError
    from trimmer.balance.leakage import harmonic_leakage as harmonic_leakage
    from trimmer.balance.limit_cycle import Certificate as Certificate
    from trimmer.balance.limit_cycle import HarmonicBalance as HarmonicBalance
    from trimmer.balance.limit_cycle import LimitCycle as LimitCycle
    from trimmer.balance.limit_cycle import UndecidedRegion as UndecidedRegion
    from trimmer.balance.solve import harmonic_balance as harmonic_balance
    from trimmer.balance.solve import limit_cycles as limit_cycles
    from trimmer.crossings import RealAxisCrossing as RealAxisCrossing
    from trimmer.crossings import gain_crossings as gain_crossings
    from trimmer.crossings import real_axis_crossings as real_axis_crossings
    from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD as CUTTER_RELATIVE_TO_GUARD
    from trimmer.displacement import Body as Body
    from trimmer.displacement import Displacement as Displacement
    from trimmer.displacement import DisplacementError as DisplacementError
    from trimmer.elements.coulomb_friction import CoulombFriction as CoulombFriction
    from trimmer.elements.element import Element as Element
    from trimmer.elements.element_at_frequency import ElementAtFrequency as ElementAtFrequency
    from trimmer.elements.friction_backlash import FrictionBacklash as FrictionBacklash
    from trimmer.elements.inertia_backlash import InertiaBacklash as InertiaBacklash
    from trimmer.elements.relay import Relay as Relay
    from trimmer.elements.scaled_element import ScaledElement as ScaledElement
    from trimmer.elements.sum_of_elements import SumOfElements as SumOfElements
    from trimmer.elements.viscous_backlash import ViscousBacklash as ViscousBacklash
    from trimmer.elements.viscous_friction import ViscousFriction as ViscousFriction
    from trimmer.errors import TrimmerError as TrimmerError
    from trimmer.extrema import Extremum as Extremum
    from trimmer.extrema import dips as dips
    from trimmer.extrema import resonance_peaks as resonance_peaks
    from trimmer.files import FileWriteError as FileWriteError
    from trimmer.files import write_whole as write_whole
    from trimmer.frequency_domain import UnsupportedSystemError as UnsupportedSystemError
    from trimmer.frequency_domain import frequency_response as frequency_response
    from trimmer.identification import IdentifiedTimeConstant as IdentifiedTimeConstant
    from trimmer.identification import identify_time_constant as identify_time_constant
    from trimmer.linear import InputChannels as InputChannels
    from trimmer.linear import linear_model as linear_model
    from trimmer.linear import pin_model as pin_model
    from trimmer.linear import transfer_function as transfer_function
    from trimmer.linear_summary import LinearSummary as LinearSummary
    from trimmer.linear_summary import summarise as summarise
    from trimmer.low_pass import asymptotic_roll_off as asymptotic_roll_off
    from trimmer.low_pass import bandwidth as bandwidth
    from trimmer.low_pass import bandwidth_crossings as bandwidth_crossings
    from trimmer.low_pass import filtering_ratio as filtering_ratio
    from trimmer.low_pass import local_slope as local_slope
    from trimmer.modal_analysis import Mode as Mode
    from trimmer.modal_analysis import UndampedMode as UndampedMode
    from trimmer.modal_analysis import modes as modes
    from trimmer.modal_analysis import undamped_modes as undamped_modes
    from trimmer.motion.component import EventKind as EventKind
    from trimmer.motion.drive import Drive as Drive
    from trimmer.motion.energy import EnergyBalance as EnergyBalance
    from trimmer.motion.energy import energy_balance as energy_balance
    from trimmer.motion.errors import IllPosedLoopError as IllPosedLoopError
    from trimmer.motion.errors import UnsupportedMotionError as UnsupportedMotionError
    from trimmer.motion.loops import ClosedLoop as ClosedLoop
    from trimmer.motion.loops import OpenLoop as OpenLoop
    from trimmer.motion.motion import Event as Event
    from trimmer.motion.motion import Motion as Motion
    from trimmer.motion.motion import Outcome as Outcome
    from trimmer.motion.simulation import simulate as simulate
    from trimmer.motion.trimmer_loop import BodyFriction as BodyFriction
    from trimmer.motion.trimmer_loop import TrimmerLoop as TrimmerLoop
    from trimmer.nyquist import PointOnLocusError as PointOnLocusError
    from trimmer.nyquist import encirclements as encirclements
    from trimmer.orbits.errors import OrbitNotFoundError as OrbitNotFoundError
    from trimmer.orbits.errors import OrbitNotFoundWarning as OrbitNotFoundWarning
    from trimmer.orbits.forced_orbit import forced_orbit as forced_orbit
    from trimmer.orbits.multi_harmonic_balance import BalancedHarmonics as BalancedHarmonics
    from trimmer.orbits.multi_harmonic_balance import multi_harmonic_balance as multi_harmonic_balance
    from trimmer.orbits.periodic_orbit import PeriodicOrbit as PeriodicOrbit
    from trimmer.orbits.periodic_orbits import periodic_orbits as periodic_orbits
    from trimmer.parameters import ParameterError as ParameterError
    from trimmer.parameters import TrimmerParameters as TrimmerParameters
    from trimmer.parameters import parameter_table as parameter_table
    from trimmer.signals.csv_layout import CsvLayout as CsvLayout
    from trimmer.signals.csv_layout import DecimalSign as DecimalSign
    from trimmer.signals.csv_layout import Delimiter as Delimiter
    from trimmer.signals.missing import MissingValues as MissingValues
    from trimmer.signals.read import read_signal as read_signal
    from trimmer.signals.signal import Signal as Signal
    from trimmer.signals.signal import SignalError as SignalError
    from trimmer.signals.wav import BitDepth as BitDepth
    from trimmer.signals.wav import WavFile as WavFile
    from trimmer.signals.wav import write_wav as write_wav
    from trimmer.signals.write import write_signal as write_signal
    from trimmer.spectra.analysis import SpectrumAnalysis as SpectrumAnalysis
    from trimmer.spectra.analysis import analyse_signal as analyse_signal
    from trimmer.spectra.classification import ClassifiedPeak as ClassifiedPeak
    from trimmer.spectra.classification import Harmonic as Harmonic
    from trimmer.spectra.classification import LimitCycleLine as LimitCycleLine
    from trimmer.spectra.classification import Match as Match
    from trimmer.spectra.classification import NaturalMode as NaturalMode
    from trimmer.spectra.classification import classify as classify
    from trimmer.spectra.harmonics import HarmonicFit as HarmonicFit
    from trimmer.spectra.harmonics import fit_harmonics as fit_harmonics
    from trimmer.spectra.peaks import Peak as Peak
    from trimmer.spectra.peaks import peaks as peaks
    from trimmer.spectra.spectrum import Spectrum as Spectrum
    from trimmer.spectra.spectrum import amplitude_spectrum as amplitude_spectrum
    from trimmer.spectra.window import Window as Window
    from trimmer.time_domain import SteadyState as SteadyState
    from trimmer.time_domain import TimeResponse as TimeResponse
    from trimmer.time_domain import steady_state as steady_state
    from trimmer.time_domain import time_response as time_response
    from trimmer.zero_pole_gain import ZeroPoleGain as ZeroPoleGain

    __version__: str

_MODULES = {
    "BalancedHarmonics": "orbits.multi_harmonic_balance",
    "BitDepth": "signals.wav",
    "Body": "displacement",
    "BodyFriction": "motion.trimmer_loop",
    "CUTTER_RELATIVE_TO_GUARD": "displacement",
    "Certificate": "balance.limit_cycle",
    "ClassifiedPeak": "spectra.classification",
    "ClosedLoop": "motion.loops",
    "CoulombFriction": "elements.coulomb_friction",
    "CsvLayout": "signals.csv_layout",
    "DecimalSign": "signals.csv_layout",
    "Delimiter": "signals.csv_layout",
    "Displacement": "displacement",
    "DisplacementError": "displacement",
    "Drive": "motion.drive",
    "Element": "elements.element",
    "ElementAtFrequency": "elements.element_at_frequency",
    "EnergyBalance": "motion.energy",
    "Event": "motion.motion",
    "EventKind": "motion.component",
    "Extremum": "extrema",
    "FileWriteError": "files",
    "FrequencyRangeError": "balance.errors",
    "FrictionBacklash": "elements.friction_backlash",
    "Harmonic": "spectra.classification",
    "HarmonicBalance": "balance.limit_cycle",
    "HarmonicFit": "spectra.harmonics",
    "IdentifiedTimeConstant": "identification",
    "IllPosedLoopError": "motion.errors",
    "InertiaBacklash": "elements.inertia_backlash",
    "InputChannels": "linear",
    "LimitCycle": "balance.limit_cycle",
    "LimitCycleLine": "spectra.classification",
    "LinearElementError": "balance.errors",
    "LinearSummary": "linear_summary",
    "Match": "spectra.classification",
    "MissingValues": "signals.missing",
    "Mode": "modal_analysis",
    "Motion": "motion.motion",
    "NaturalMode": "spectra.classification",
    "OpenLoop": "motion.loops",
    "OrbitNotFoundError": "orbits.errors",
    "OrbitNotFoundWarning": "orbits.errors",
    "Outcome": "motion.motion",
    "ParameterError": "parameters",
    "Peak": "spectra.peaks",
    "PeriodicOrbit": "orbits.periodic_orbit",
    "PointOnLocusError": "nyquist",
    "RealAxisCrossing": "crossings",
    "Relay": "elements.relay",
    "ScaledElement": "elements.scaled_element",
    "Signal": "signals.signal",
    "SignalError": "signals.signal",
    "Spectrum": "spectra.spectrum",
    "SpectrumAnalysis": "spectra.analysis",
    "SteadyState": "time_domain",
    "SumOfElements": "elements.sum_of_elements",
    "TimeResponse": "time_domain",
    "TrimmerError": "errors",
    "TrimmerLoop": "motion.trimmer_loop",
    "TrimmerParameters": "parameters",
    "UndampedMode": "modal_analysis",
    "UndecidedRegion": "balance.limit_cycle",
    "UndecidedWarning": "balance.errors",
    "UnsupportedElementError": "balance.errors",
    "UnsupportedMotionError": "motion.errors",
    "UnsupportedSystemError": "frequency_domain",
    "ViscousBacklash": "elements.viscous_backlash",
    "ViscousFriction": "elements.viscous_friction",
    "WavFile": "signals.wav",
    "Window": "spectra.window",
    "ZeroPoleGain": "zero_pole_gain",
    "amplitude_spectrum": "spectra.spectrum",
    "analyse_signal": "spectra.analysis",
    "asymptotic_roll_off": "low_pass",
    "bandwidth": "low_pass",
    "bandwidth_crossings": "low_pass",
    "classify": "spectra.classification",
    "dips": "extrema",
    "encirclements": "nyquist",
    "energy_balance": "motion.energy",
    "filtering_ratio": "low_pass",
    "fit_harmonics": "spectra.harmonics",
    "forced_orbit": "orbits.forced_orbit",
    "frequency_response": "frequency_domain",
    "gain_crossings": "crossings",
    "harmonic_balance": "balance.solve",
    "harmonic_leakage": "balance.leakage",
    "identify_time_constant": "identification",
    "limit_cycles": "balance.solve",
    "linear_model": "linear",
    "local_slope": "low_pass",
    "modes": "modal_analysis",
    "multi_harmonic_balance": "orbits.multi_harmonic_balance",
    "parameter_table": "parameters",
    "peaks": "spectra.peaks",
    "periodic_orbits": "orbits.periodic_orbits",
    "pin_model": "linear",
    "read_signal": "signals.read",
    "real_axis_crossings": "crossings",
    "resonance_peaks": "extrema",
    "simulate": "motion.simulation",
    "steady_state": "time_domain",
    "summarise": "linear_summary",
    "time_response": "time_domain",
    "transfer_function": "linear",
    "undamped_modes": "modal_analysis",
    "write_signal": "signals.write",
    "write_wav": "signals.wav",
    "write_whole": "files",
}

__all__ = ["__version__", *_MODULES]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return _version()
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("trimmer")
    except PackageNotFoundError:
        return "unknown (not installed)"
