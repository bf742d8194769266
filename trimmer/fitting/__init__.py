"""Numbers of a mechanism fitted to a measured steady motion, with what the measurement says of them.

``measured`` takes the lines of the drive and the noise between them from the samples, with the help of
``stray``. ``unknowns`` are the numbers that are fitted, in coordinates without units; ``model`` is the exact
orbit for their values, and ``misfit`` its whitened distance from the measurement. ``search`` brings that down
from several starts; ``profile`` gives the intervals, ``weak`` what cannot be told apart, and ``judgement``
says whether the mechanism explains the measurement. ``fit`` is the entry, ``result`` what it gives.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
