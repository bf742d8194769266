"""All data that are kept for the answers."""

from typing import Final

from report.numbers.future_work.compensation import COMPENSATION
from report.numbers.future_work.felt import FELT
from report.numbers.future_work.harmonics import HARMONICS
from report.numbers.future_work.load import LOAD
from report.numbers.future_work.scatter import SCATTER
from report.numbers.future_work.second_play import SECOND_PLAY

ANSWERS: Final = (COMPENSATION, HARMONICS, SECOND_PLAY, SCATTER, LOAD, FELT)  # In the order of section 6.4
