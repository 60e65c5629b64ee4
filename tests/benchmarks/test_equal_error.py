"""Equal error is found where it is."""

import numpy as np
import pytest
from benchmarks.equal_error import crossing

TOLERANCES = 10.0 ** -np.arange(2, 10, 0.25)


def test_the_crossing_of_a_line_is_where_the_line_crosses():
    assert crossing(TOLERANCES, 300 * TOLERANCES, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=1e-12)


def test_one_tolerance_is_neither_lucky_nor_unlucky():
    """The tolerance just before the crossing comes out far too well, a tight one far too badly."""
    errors = 300 * TOLERANCES
    last = np.flatnonzero(errors > 5e-5)[-1]
    errors[last], errors[last + 6] = 1e-9, 1.0
    assert crossing(TOLERANCES, errors, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=0.4)


def test_a_loose_tolerance_counts_only_with_all_tighter_ones():
    errors = 300 * TOLERANCES
    errors[:8] = 1e-9  # where the error is no longer that of the run asked for
    assert crossing(TOLERANCES, errors, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=1e-12)


def test_an_accuracy_never_reached_has_no_tolerance():
    assert crossing(TOLERANCES, 300 * TOLERANCES, 1e-9, reach=2) is None
    assert crossing(TOLERANCES, np.where(TOLERANCES > 1e-5, np.inf, 300 * TOLERANCES), 1.0, reach=2) <= 1e-5
