"""The linear trimmer, and the analysis of any linear system.

``model`` builds the trimmer and ``modes`` finds its modes; ``zero_pole_gain`` factors a system, on which
``extrema``, ``crossings``, ``low_pass`` and ``nyquist`` rest; ``response_at`` and ``time_response``
evaluate it; ``summary`` collects all of that for one trimmer.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
