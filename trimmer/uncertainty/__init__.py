"""What a mechanism does when its numbers scatter: distributions, samples, yield, and which number matters.

``sample_mechanism(read_sample_file("mine.toml"))`` draws machines and finds what each of them settles to;
``study_samples`` adds Sobol indices and harmonic balance.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
