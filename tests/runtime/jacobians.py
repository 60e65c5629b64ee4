"""The Jacobian that implicit steps take against differences of the rates."""

import numpy as np

from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.implicit_step import linearised
from hertzwerk.runtime.engine.solution.error_scales import of_parameters


def start_of(model, bound):
    """Coordinates and speeds at the start."""
    return tuple(np.array(x).ravel() for x in model.function("start")(bound.p))


def check_jacobian(model, y, mode, memory, bound, *, steps=1e-6, within=1e-6):
    """Of the state and of time, each row by its largest entry; `steps` are those of the differences, in scales or one for each entry."""
    given = (mode, memory, bound.c)
    J, over_time = (np.array(x) for x in linearised(model)(0.0, y, *given))
    rates = flow(model).rates

    def slope(t, y):
        return np.array(rates(t, y, *given)).ravel()

    steps = steps * of_parameters(model, bound).state if np.ndim(steps) == 0 else np.asarray(steps)
    columns = [
        (slope(0.0, y + h) - slope(0.0, y - h)) / (2 * size) for h, size in zip(np.diag(steps), steps, strict=True)
    ]
    largest = np.max(np.abs(J), axis=1, keepdims=True) + 1e-300
    assert np.max(np.abs(J)) > 0
    assert np.max(np.abs(np.array(columns).T - J) / largest) < within
    by_time = (slope(1e-9, y) - slope(-1e-9, y)) / 2e-9
    np.testing.assert_allclose(over_time.ravel(), by_time, rtol=1e-5, atol=1e-5 * np.max(np.abs(by_time)))
    return J
