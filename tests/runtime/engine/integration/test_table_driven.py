"""A surface that a table drives: its contact against the closed form, and the rounding of gaps that look a table up."""

import math

import casadi as ca
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.program.emit.helpers import HELPERS
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS, bounds

GRAVITY, HEIGHT, RISING = 9.81, 0.1, 0.5


@pytest.fixture(scope="module")
def lifted():
    """A ball that falls on a platform, which a table lifts at a constant speed."""
    radius = hd.Parameter("radius", "mm", 20)
    ball, platform = hd.Body("ball", hd.Parameter("m", "kg", 0.1)), hd.Body("platform", hd.Parameter("mp", "kg", 1))
    lift = hd.Table("lift", (0, 1, 2), (0, RISING, 2 * RISING), ("s", "m"))
    guides = hd.Prismatic("fall", hd.GROUND, ball, axis=hd.Y), hd.Prismatic("guide", hd.GROUND, platform, axis=hd.Y)
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), radius, platform.at(0, 0, 0), normal=hd.Y)
    stiffness, restitution = hd.Parameter("K", "N/m^1.5", 1e8), hd.Parameter("e", "1", 0.8)
    return load(
        hd.Scene(
            hd.Mechanism("lifted", guides, (floor,)),
            effects=(
                hd.Gravity("gravity", hd.Parameter("g", "m/s^2", GRAVITY), direction=-hd.Y),
                hd.Drive("hoist", "guide", position=lift(hd.T)),
                hd.Contact("floor", hd.laws.power(stiffness, n=1.5), hd.laws.flores(restitution)),
            ),
            start=hd.Start(position={"fall": radius + hd.Parameter("height", "m", HEIGHT)}),
            scales=hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 1)),
        )
    )


@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_a_ball_meets_a_platform_that_a_table_lifts(lifted, method):
    run = simulate(lifted, duration="0.15 s", tolerance=1e-10, method=method)
    meeting = math.sqrt(RISING**2 + 2 * GRAVITY * HEIGHT)
    assert run.impacts[0].speed == pytest.approx(meeting, rel=1e-9)
    assert run.impacts[0].t == pytest.approx((meeting - RISING) / GRAVITY, rel=1e-9)


def test_a_table_looked_up_passes_on_the_rounding_of_its_argument():
    helpers = {"ca": ca}
    exec(HELPERS["_spline"], helpers)
    x, rows = ca.SX.sym("x"), ((0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 0.0), (1.0, 4.0, 3.0, 0.0, 0.0, 0.0, 0.0))
    looked_up = ca.Function("looked_up", [x], [helpers["_spline"](rows, x)[0]])
    error = float(bounds(looked_up, (0,))(0.5))
    own, argument = EPS * 2.5, 3 * EPS * 0.5  # 1 + 3 x at 0.5
    assert own + argument <= error <= own + 3 * argument
    assert float(bounds(looked_up, ())(0.5)) == own
