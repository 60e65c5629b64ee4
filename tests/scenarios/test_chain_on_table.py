"""A chain on a table: at rest every pin carries the weight of a link, both free ends half of one."""

import numpy as np
import pytest

from hertzwerk.derive.scenes.chain_on_table import chain_on_table
from hertzwerk.runtime import load, simulate

WEIGHT = 5e-3 * 9.81


@pytest.mark.exhaustive
def test_a_hundred_links_come_to_rest_with_the_forces_of_statics():
    n = 100
    run = simulate(load(chain_on_table(n)), duration="1 s", tolerance=1e-5, parameters={"inclination": "1 deg"})
    end = run.at([1.0])
    forces = np.array([end[f"ball_{i}.normal_force"][0] for i in range(n + 1)])
    assert run.outcome.name == "finished"
    assert forces == pytest.approx(np.array([0.5, *[1.0] * (n - 1), 0.5]) * WEIGHT, rel=1e-3)
    assert run.energy_residual < 1e-5
