"""What a mechanism or a loop does when its numbers scatter: distributions, samples, yield, what matters.

``sample(subject, uncertainty)`` draws machines or loops and finds what each of them settles to;
``study_samples`` adds Sobol indices and harmonic balance. ``sample_limit_cycles`` draws trimmers whose limit
cycles harmonic balance predicts.
"""

import lazy_loader

from trimmer.former_names import answering

_attribute, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
FORMER = {
    "LoopFile": "trimmer.uncertainty.ParameterSampleFile",
    "LoopNumbers": "trimmer.uncertainty.ParameterNumbers",
    "LoopSamples": "trimmer.uncertainty.LimitCycleSamples",
    "read_loop_file": "trimmer.uncertainty.read_parameter_sample_file",
    "sample_loop": "trimmer.uncertainty.sample_limit_cycles",
}
"""Where what had other names stands now."""
__getattr__ = answering(__name__, _attribute, FORMER)
