"""Samples as text and as JSON."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.command_line.json_values import document, picked
from trimmer.command_line.table import table
from trimmer.design import Measure, MeasureOfPart
from trimmer.mechanism.mechanism import Mechanism
from trimmer.uncertainty.balance import BalancedSamples
from trimmer.uncertainty.indices import Indices
from trimmer.uncertainty.samples import Samples
from trimmer.uncertainty.statistics import Distribution, Share, distribution_of, share_of
from trimmer.uncertainty.study import SampleStudy, name_of

MOST_LINES = 8  # Numbers that the text lists for each quantity


def as_text(study: SampleStudy) -> str:
    """Return what samples tell, for people."""
    samples = study.samples
    lines = [*_yield_lines(samples), "what it settles to"]
    total, width = len(samples.trials), max(map(len, samples.kinds), default=0)
    lines += [
        f"  {kind:<{width}}  {share_text(share_of(count, total))}" for kind, count in samples.kinds.items()
    ]
    lines += ["", "how measures scatter (in brackets: 95 % interval of a quantile)"]
    lines += distribution_lines(
        (name_of(each), samples.measured(each), each.unit(samples.flow)) for each in _shown(samples)
    )
    lines += index_lines(_named(study))
    if study.balanced is not None:
        lines += ["", *_balanced_lines(study.balanced)]
    lines += ["", samples.message]
    if math.isfinite(study.per_second):
        lines.append(f"{study.per_second:.3g} samples per second.")
    return "\n".join(lines)


def _yield_lines(samples: Samples) -> Iterator[str]:
    if not isinstance(samples.inputs.subject, Mechanism):
        return  # The file of its parameters has no targets.
    if not samples.targets:
        yield "no targets: write what is wanted below [targets] to learn the yield"
    else:
        met = share_of(int(samples.met.sum()), len(samples.trials))
        yield f"all targets are met by {share_text(met)}"
        if len(samples.targets) > 1:
            for target in samples.targets:
                count = sum(trial.meets((target,)) for trial in samples.trials)
                name = f"{target.key} {target.part}".strip()
                yield f"  {name}: {share_text(share_of(count, len(samples.trials)))}"
    yield ""


def share_text(share: Share) -> str:
    """Return a share with its interval."""
    return f"{share.value:.1%} of {share.total} ({share.lowest:.1%} to {share.highest:.1%})"


def _shown(samples: Samples) -> list[MeasureOfPart]:
    return [each for each in samples.asked if each.measure is not Measure.PERIOD]


def _named(study: SampleStudy) -> dict[str, Indices]:
    return {quantity.name: indices for quantity, indices in study.indices.items()}


def distribution_lines(columns: Iterable[tuple[str, Reals, str]]) -> list[str]:
    """Return the table of distributions of some values, each with its name and unit."""
    rows = []
    for name, values, unit in columns:
        found = distribution_of(values)
        if found is not None:
            quantiles = (f"{q.value:.4g} [{q.lowest:.4g}, {q.highest:.4g}]" for q in found.quantiles)
            of = "" if found.count == len(values) else f", where finite: {found.count} of {len(values)}"
            rows.append((name + of, f"{found.mean:.4g}", f"{found.deviation:.3g}", *quantiles, unit))
    return table(("", "mean", "deviation", "5 %", "50 %", "95 %", "unit"), rows)


def index_lines(indices: Mapping[str, Indices]) -> Iterator[str]:
    """Return the table of indices of each quantity, by its name, and what they rest on."""
    for quantity, found in indices.items():
        yield from ("", f"what matters for {quantity}")
        rows = [
            (
                each.place,
                f"{each.first:.3f} +- {each.first_error:.3f}",
                f"{each.total:.3f} +- {each.total_error:.3f}",
            )
            for each in found.indices[:MOST_LINES]
        ]
        if rows:
            yield from table(("", "first order", "total"), rows)
        yield f"  {found.message}"


def _balanced_lines(balanced: BalancedSamples) -> Iterator[str]:
    if not balanced.numbers:
        yield "harmonic balance: no sample repeats, so there is nothing to hold it against"
        return
    far, converged = balanced.distances, int(balanced.converged.sum())
    yield (
        f"harmonic balance with {balanced.harmonics} harmonics, of {len(far)} samples: {converged} balance; "
        f"distance to the exact orbit {np.median(far):.2g} in the middle, {far.max():.2g} at most"
    )


def as_json(study: SampleStudy) -> str:
    """Return what samples tell, for programs; see docs/json.md."""
    samples = study.samples
    total = len(samples.trials)
    data = {
        "count": len(samples.inputs.values),
        **picked(samples, "impossible", "failed"),
        **picked(samples.inputs.settings, "plan", "seed"),
        "periods": samples.inputs.settings.most_periods,
        "scatters": [
            picked(each, "place", "unit", "assumed") for each in samples.inputs.uncertainty.scatters
        ],
        "yield": share_data(share_of(int(samples.met.sum()), total)) if samples.targets else None,
        "targets": [
            {
                **picked(target, "key", "part", "bound"),
                **share_data(share_of(sum(trial.meets((target,)) for trial in samples.trials), total)),
            }
            for target in samples.targets
        ],
        "kinds": {kind: share_data(share_of(count, total)) for kind, count in samples.kinds.items()},
        "measures": [
            {
                "measure": asked.measure.name.lower(),
                "part": asked.part,
                "unit": asked.unit(samples.flow),
                **distribution_data(distribution_of(samples.measured(asked))),
            }
            for asked in _shown(samples)
        ],
        "indices": index_data(_named(study)),
        "balance": None if study.balanced is None else _balanced(study.balanced),
        "message": samples.message,
    }
    return document(data)


def share_data(share: Share) -> dict[str, Any]:
    """Return a share as data for JSON."""
    return {"count": share.count, "share": share.value, "interval": [share.lowest, share.highest]}


def distribution_data(found: Distribution | None) -> dict[str, Any]:
    """Return a distribution as data for JSON."""
    if found is None:
        return {"count": 0, "mean": None, "deviation": None, "quantiles": []}
    return {
        **picked(found, "count", "mean", "deviation"),
        "quantiles": [
            {**picked(each, "share", "value"), "interval": [each.lowest, each.highest]}
            for each in found.quantiles
        ],
    }


def index_data(indices: Mapping[str, Indices]) -> list[dict[str, Any]]:
    """Return indices as data for JSON."""
    names = ("place", "first", "total", "first_error", "total_error")
    return [
        {"of": of, "message": found.message, "numbers": [picked(each, *names) for each in found.indices]}
        for of, found in indices.items()
    ]


def _balanced(balanced: BalancedSamples) -> dict[str, Any]:
    return {
        "harmonics": balanced.harmonics,
        "samples": balanced.numbers,
        **picked(balanced, "distances", "converged"),
    }
