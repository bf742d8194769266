"""Numbers of what moves fitted to a measured steady motion, with what the measurement says of them.

``measured`` takes the lines of the drive and the noise between them from the samples, with the help of
``stray``. ``unknowns`` are the numbers that are fitted, in coordinates without units; ``model`` is the exact
orbit for their values, and ``misfit`` its whitened distance from the measurement. ``search`` brings that down
from several starts; ``profile`` gives the intervals, ``weak`` what cannot be told apart, and ``judgement``
says whether the mechanism explains the measurement. ``fit``, which is ``trimmer.fit``, is the entry, and
``result`` what it gives.
"""

import lazy_loader

from trimmer.former_names import answering

_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
FORMER = {"fit_mechanism": "trimmer.fit"}  # Where what had other names stands now
__getattr__ = answering(__name__, _attribute, FORMER)
