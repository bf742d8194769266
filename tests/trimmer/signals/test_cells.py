import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from trimmer.signals import DecimalSign
from trimmer.signals.cells import numbers_in
from trimmer.signals.text_file import SignalFileError


@given(
    st.lists(
        st.one_of(st.floats().map(repr), st.integers().map(str), st.text("0123456789.,+-eE _\t", max_size=6)),
        min_size=1,
    ),
    st.sampled_from([None, *DecimalSign]),
)
def test_reading_a_column_at_once_changes_nothing(cells: list[str], decimal) -> None:
    """The fast way through a clean column gives what the slow way gives cell by cell."""

    def outcome(column: list[str]) -> list[float] | str:
        try:
            return numbers_in(column, list(range(1, len(column) + 1)), decimal, "file").tolist()
        except SignalFileError as error:
            return str(error)

    together = outcome(cells)
    with_a_missing_value = outcome([*cells, "nan"])  # is not clean, so it takes the slow way
    if isinstance(together, list):
        assert isinstance(with_a_missing_value, list)
        np.testing.assert_array_equal(together, with_a_missing_value[:-1])
    else:
        assert together == with_a_missing_value
