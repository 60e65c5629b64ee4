"""The benchmark bicycle: eigenvalues against Meijaard, Papadopoulos, Ruina, Schwab, Proc. R. Soc. A 463 (2007) 1955, table 2.

Whipple's model: knife-edge wheels that roll without slip. States lean and steer; the map over a time T of the exact derivatives of a run is exp(A T).
"""

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate

PUBLISHED = {  # speed [m/s] -> castering, capsize, weave [1/s]
    5.0: (-14.07838969279822, -0.32286642900409, -0.77534188219585, 4.46486771378823),
}


def test_the_benchmark_bicycle_has_its_published_eigenvalues():
    model, duration = load("bicycle"), 0.2
    names = [f"{joint}.{what}" for what in ("angle", "speed") for joint in ("lean", "steer")]
    for speed, (castering, capsize, weave, frequency) in PUBLISHED.items():
        run = simulate(
            model, duration=duration, parameters={"speed": f"{speed} m/s", "push": "0 rad/s"}, tolerance=1e-11
        )
        assert run.outcome.finished
        by = run.sensitivities(*names)
        growth = np.array([[by[of, name][-1] for name in names] for of in names])
        actual = np.sort_complex(np.log(np.linalg.eigvals(growth).astype(complex)) / duration)
        expected = [castering, capsize, weave + 1j * frequency, weave - 1j * frequency]
        assert actual == pytest.approx(np.sort_complex(np.array(expected)), rel=1e-8)
