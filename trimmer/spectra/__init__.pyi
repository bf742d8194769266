"""The public names of this room, each imported on first use."""

from .analysis import SpectrumAnalysis as SpectrumAnalysis
from .analysis import analyse_signal as analyse_signal
from .averaged import AveragedLine as AveragedLine
from .averaged import AveragedSpectrum as AveragedSpectrum
from .averaged import averaged_spectrum as averaged_spectrum
from .classification import ClassifiedPeak as ClassifiedPeak
from .classification import DriveFraction as DriveFraction
from .classification import Harmonic as Harmonic
from .classification import LimitCycleLine as LimitCycleLine
from .classification import MainsHum as MainsHum
from .classification import Match as Match
from .classification import NaturalMode as NaturalMode
from .classification import OwnMultiple as OwnMultiple
from .classification import Tolerance as Tolerance
from .classification import classify as classify
from .comparison import MotionComparison as MotionComparison
from .comparison import SimulatedLines as SimulatedLines
from .comparison import compare_motions as compare_motions
from .harmonics import HarmonicFit as HarmonicFit
from .harmonics import fit_harmonics as fit_harmonics
from .own_lines import with_own_lines as with_own_lines
from .peaks import Peak as Peak
from .spectrum import Spectrum as Spectrum
from .spectrum import amplitude_spectrum as amplitude_spectrum
from .window import Window as Window
