"""The derivations are told as they were: ``kept_steps.py`` says how the files are written anew."""

from difflib import unified_diff

import pytest
import sympy

from tests.derivations.kept_steps import FOLDER, NARRATIVES, SOURCES, written


@pytest.mark.skipif(not sympy.__version__.startswith("1.14"), reason="others put terms in another order")
@pytest.mark.parametrize("name", [*NARRATIVES, *SOURCES])
def test_derivations_are_told_as_they_were(name: str) -> None:
    kept = FOLDER.joinpath(f"{name}.txt").read_text("utf-8").splitlines()
    unlike = list(unified_diff(kept, written(name).splitlines(), "kept", "told now", n=0, lineterm=""))
    assert not unlike, "\n".join(unlike[:40])
