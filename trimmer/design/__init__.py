"""A design judged against its targets: motions, maps, margins, sensitivities and remedies, without prose.

``Study(read_design_file("mine.toml")).whole()`` is what the report of ``trimmer design`` rests on; each
method of a ``Study`` gives a part of it.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
