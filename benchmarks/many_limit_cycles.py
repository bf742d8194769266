"""Limit cycles of many trimmers at once, beside `limit_cycles` of each in the same run.

Run it with `python -m benchmarks.many_limit_cycles`. Parameters vary by 10 % and gaps from 10 to 100 um. Both
take turns in one process; times are processor time of one core.
"""

import time
import warnings
from argparse import ArgumentParser
from dataclasses import asdict

import numpy as np

from benchmarks.calibration import sentence
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.limit_cycles import sampled_limit_cycles
from trimmer.linear.model import pin_model
from trimmer.parameters import TrimmerParameters

COUNT = 20_000
SINGLE = 300  # As many are computed one by one
ROUNDS = 3
TARGET = 20_000  # Trimmers per second and core, on an idle machine


def main() -> None:
    """Measure and print."""
    random = np.random.default_rng(1)
    thesis = asdict(TrimmerParameters.thesis())
    samples = {name: value * random.uniform(0.9, 1.1, COUNT) for name, value in thesis.items()}
    gaps = random.uniform(1e-5, 1e-4, COUNT)
    sampled_limit_cycles({}, gap=gaps[:2])
    together, single = [], []
    for _ in range(ROUNDS):
        begin = time.process_time()
        found = sampled_limit_cycles(samples, gap=gaps)
        middle = time.process_time()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for row in range(SINGLE):
                parameters = TrimmerParameters(**{name: float(each[row]) for name, each in samples.items()})
                cycles = limit_cycles(pin_model(parameters), FrictionBacklash(float(gaps[row])))
                if len(cycles) != found.count[row]:
                    raise SystemExit(
                        f"sample {row}: {found.count[row]} limit cycles instead of {len(cycles)}"
                    )
        single.append((time.process_time() - middle) / SINGLE)
        together.append((middle - begin) / COUNT)
    print(f"together: {1 / min(together):.0f} trimmers per second and core (target {TARGET})")
    print(f"one by one: {1 / min(single):.0f} per second")
    print(f"together is {min(single) / min(together):.0f} times as fast")
    print(found.message)
    print(sentence())


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
