"""Two units stepped in turns against one scene: first order in the communication step with inputs held, second at rates."""

import pytest
from coupled import study


@pytest.mark.exhaustive
def test_co_simulation_costs_accuracy_as_its_order_says(tmp_path):
    rows, own, impacts = study(tmp_path, (100, 1000))
    assert impacts > 10
    assert own < 1e-6
    (_, held, linear), (_, held_10, linear_10) = rows
    assert 8 < held / held_10 < 13
    assert 60 < linear / linear_10 < 250
    assert linear < held / 100
