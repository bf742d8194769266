"""Arguments with a few possible values take a member or its word, and nothing else."""

from collections.abc import Callable
from enum import Enum
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report.pages.formats import Format, Paper
from report.rendering.request import Request
from trimmer import CoulombFriction, Signal, TrimmerParameters, pin_model, summarise, transfer_function
from trimmer.choices import Choice, ChoiceError
from trimmer.loops import BodyFriction, TrimmerLoop
from trimmer.signals import BitDepth, CsvLayout, DecimalSign, Delimiter, MissingValues, read_signal, write_wav
from trimmer.spectra import Window, amplitude_spectrum, analyse_signal
from trimmer.thesis import Displacement, DisplacementError, InputChannels, TrimmerBody, linear_model

P = TrimmerParameters.thesis()
SINE = np.sin(2 * np.pi * 110 * np.arange(8000) / 8000)
CHOICES = [InputChannels, MissingValues, Window, Delimiter, DecimalSign, BitDepth, TrimmerBody, Format, Paper]


def shown(model: Any) -> list[float]:
    return [*np.ravel(model.B), *np.ravel(model.C), *np.ravel(model.D)]


def missing(value: Any, folder: Path) -> Any:
    path = folder / "samples.csv"
    path.write_text("\n".join([*map(str, range(30)), "", *map(str, range(31, 60))]))
    return read_signal(path, sample_rate=1000.0, missing=value).interpolated


USES: list[tuple[type[Choice], Callable[[Any, Path], Any]]] = [
    (InputChannels, lambda value, folder: shown(pin_model(P, channels=value))),
    (InputChannels, lambda value, folder: transfer_function(P, channels=value).num[0][0].tolist()),
    (InputChannels, lambda value, folder: summarise(P, channels=value)),
    (InputChannels, lambda value, folder: TrimmerLoop(P, channels=value).channels),
    (Window, lambda value, folder: amplitude_spectrum(SINE, 8000.0, value).window),
    (Window, lambda value, folder: analyse_signal(Signal(SINE, 8000.0), window=value).spectrum.window),
    (Delimiter, lambda value, folder: CsvLayout(delimiter=value)),
    (DecimalSign, lambda value, folder: CsvLayout(decimal=value)),
    (BitDepth, lambda value, folder: write_wav(folder / "a.wav", SINE, 8000.0, value)),
    (TrimmerBody, lambda value, folder: Displacement(value)),
    (Format, lambda value, folder: Request(formats=frozenset({value}))),
    (Paper, lambda value, folder: Request(paper=value)),
]
"""Whatever takes a choice; what it returns depends on the choice."""


@pytest.mark.parametrize(("kind", "use"), USES)
def test_a_word_is_as_good_as_its_member(kind, use, tmp_path) -> None:
    results = []
    for number, member in enumerate(kind):
        (tmp_path / str(number)).mkdir()
        expected = use(member, tmp_path / str(number))
        (tmp_path / f"{number} again").mkdir()
        assert use(member.word, tmp_path / f"{number} again") == expected
        assert expected not in results
        results.append(expected)


@pytest.mark.parametrize(("kind", "use"), USES)
@pytest.mark.parametrize("value", ["nonsense", "", 7, 0.5, True, b"hann", Path("hann"), ("hann",), Enum])
def test_anything_else_is_refused_with_the_words(kind, use, value, tmp_path) -> None:
    with pytest.raises(ChoiceError) as raised:
        use(value, tmp_path)
    for member in kind:
        assert member.word in str(raised.value)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("kind", CHOICES)
def test_a_member_of_another_choice_is_refused(kind: type[Choice]) -> None:
    for other in CHOICES:
        for member in other:
            if other is not kind:
                with pytest.raises(ChoiceError):
                    kind.chosen(member, "argument")


@pytest.mark.parametrize("value", ["output", "q5", "", 2, None, True, TrimmerBody.CUTTER])
def test_what_is_no_displacement_is_refused(value: Any) -> None:
    uses: list[Callable[[], object]] = [
        lambda: linear_model(P, [value]),
        lambda: pin_model(P, value),
        lambda: transfer_function(P, value),
        lambda: summarise(P, value),
        lambda: TrimmerLoop(P, output=value),
        lambda: BodyFriction(value, CoulombFriction(1.0)),
    ]
    for use in uses:
        with pytest.raises(DisplacementError, match="is not a displacement: write a coordinate"):
            use()
