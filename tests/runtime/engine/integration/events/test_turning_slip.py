"""Directions of sliding that turn fast where a body in space breaks loose or comes to rest: explicit methods pass in few steps."""

from dataclasses import replace

import numpy as np
import pytest
from balls import MASS, ball, dry
from bodies_on_planes import body_of, run
from each import each

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.loop.turning_slip import FOLLOWED, PASSING, implicit_near_rest, turning_rate
from hertzwerk.runtime.engine.integration.step.layout import CALM, FINISHED, RUNNING, SUSPECT, layouts
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import dopri5
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import esdirk54
from hertzwerk.runtime.loading import engine_model

MU, SPEED = 0.2, 1.0


@pytest.fixture(scope="module")
def sliding():
    """The rows of a ball that slides and comes to roll, the run's controls, and its model."""
    model = engine_model(ball(dry(MU)))
    history = simulate(
        model, duration="0.2 s", tolerance=1e-8, initial={"flight.x_speed": f"{SPEED} m/s"}
    ).engine.history
    return model, history.rows, history.controls


def test_the_rate_is_that_of_a_ball(sliding):
    """mu N (2/m + 2 R^2/J)/|s| with J = 2/5 m R^2, of both tangents; of one that rolls none."""
    model, rows, controls = sliding
    state = layouts(model).state
    speeds, forces = (rows[:, state[part]][:, 0] for part in ("margin", "force"))
    actual = np.array([float(turning_rate(model)(row, controls)) for row in rows])
    rolls = np.all(rows[:, state["m"]][:, -2:] == 0, axis=1)
    slides = ~rolls & (speeds > 1e-3)
    assert slides.sum() > 5 and rolls.sum() > 2
    np.testing.assert_allclose(actual[slides], MU * forces[slides] / MASS * 7 / speeds[slides], rtol=1e-7)
    assert not actual[rolls].any()


def test_the_method_that_passes_is_the_implicit_one(sliding):
    model, rows, controls = sliding
    state, tables = layouts(model).state, (dopri5(), esdirk54())
    row = rows[len(rows) // 4].copy()
    rate = float(turning_rate(model)(row, controls))

    def chosen(part, *, taken=tables, alone=True, accepted=1.0, method=0.0, status=RUNNING):
        given = {"h": part * FOLLOWED / rate, "accepted": accepted, "method": method, "status": status}
        for name, value in given.items():
            row[state[name]] = value
        found = implicit_near_rest(model, tables, taken, alone=alone)(row, controls).full().ravel()
        return tuple(float(found[state[name]][0]) for name in ("method", "status", "pressure"))

    assert chosen(0.9) == (0, RUNNING, row[state["pressure"]][0])
    assert chosen(1.1) == (1, RUNNING, PASSING)
    assert chosen(1.1, taken=tables[:1]) == (1, SUSPECT, PASSING)
    assert chosen(0.9, method=1.0)[0] == 0
    assert chosen(0.9, method=1.0, alone=False)[0] == 1  # something else chose it
    assert chosen(0.9, method=1.0, accepted=0.0)[0] == 1  # a step that failed is tried again by its own method
    assert chosen(1.1, accepted=0.0)[0] == 0
    assert chosen(1.1, status=CALM)[1] == RUNNING
    assert chosen(1.1, status=FINISHED)[:2] == (0, FINISHED)


LOOSE = {  # of that body: when it breaks loose, and where it is .0232 s later, by `reference.body_on_plane`
    "x": 0.0538538319372, "y": -0.039724814041, "angular_speed_x": -21.5811443097, "angular_speed_y": -16.42904481, "angular_speed_z": 0.185090485791,
}  # fmt: skip


@each("method", ["dopri5", "dop853"])
def test_a_body_breaks_loose_in_few_steps(method):
    """A lopsided ball, after .146830352 s: dopri5 took a million steps for .3 ms of what follows, and stalled.

    With smooth friction dopri5 takes 1,900 for all .17 s.
    """
    actual = run(replace(body_of(219, 77), duration=0.17), tolerance=1e-9, method=method, max_steps=2000)
    assert actual.outcome.finished
    last = np.flatnonzero(actual["floor.slip"] == 0)[-1]
    assert actual.t[last + 1] == pytest.approx(0.14683035198, abs=2e-9)
    for name, value in LOOSE.items():
        scale = actual.engine.scales.state[list(actual.engine.model.units).index(f"flight.{name}")]
        assert actual.engine.final[f"flight.{name}"] == pytest.approx(value, abs=3e-8 * scale)
