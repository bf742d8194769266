"""What compiles ahead of a run says nothing where it fails, so that here it must not."""

from collections.abc import Callable

import pytest

from tests.kernels import SHARES


@pytest.mark.parametrize("share", SHARES)
def test_a_share_moves_what_it_compiles(share: Callable[[], None]) -> None:
    share()
