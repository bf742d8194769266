"""The public names of this room, each imported on first use."""

from .band import Band as Band
from .convert import Conversion as Conversion
from .csv_layout import CsvLayout as CsvLayout
from .csv_layout import DecimalSign as DecimalSign
from .csv_layout import Delimiter as Delimiter
from .fault import Clipping as Clipping
from .fault import Dropout as Dropout
from .fault import FewSteps as FewSteps
from .fault import Offset as Offset
from .quantity import MotionQuantity as MotionQuantity
from .read import MissingValues as MissingValues
from .read import read_recording as read_recording
from .read import read_signal as read_signal
from .reading_wav import read_wav as read_wav
from .recording import Gap as Gap
from .recording import Recording as Recording
from .sampling import Gaps as Gaps
from .sampling import Sampling as Sampling
from .sampling import TimeStamps as TimeStamps
from .signal import Signal as Signal
from .signal import SignalError as SignalError
from .wav import BitDepth as BitDepth
from .wav import WavFile as WavFile
from .wav import write_wav as write_wav
from .write import write_signal as write_signal
