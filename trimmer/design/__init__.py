"""A design judged against its targets: motions, maps, margins, sensitivities and remedies, without prose.

``Study(read_design_file("mine.toml")).whole()`` is what the report of ``trimmer design`` rests on; each
method of a ``Study`` gives a part of it.

``specification`` is what is asked, ``analysis`` what one mechanism does, ``trials`` what others like it do,
and ``parameter_studies`` maps and branches over its numbers. Imports go that way only.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
