"""The spline through a table: against SciPy's, its order on a sine, its continuation, and its place in a module."""

import math
from itertools import pairwise

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from derived import Derived
from scipy.interpolate import make_interp_spline

import hertzwerk.derive as hd
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.notation import latex_of, text_of
from hertzwerk.derive.expressions.algebra.splines import Spline

SIZE = hd.Parameter("size", "m", 1.0)


def curve(table, x):
    """Values of the polynomials, by NumPy."""
    rows = np.array(table.pieces())
    k = np.clip(np.searchsorted(rows[:, 0], x, side="right") - 1, 0, len(rows) - 2)
    return sum(rows[k, 1 + power] * (x - rows[k, 0]) ** power for power in range(6))


@pytest.mark.parametrize("slopes", [None, (0.3, -2.0)])
@pytest.mark.parametrize("count", [6, 7, 25])
def test_it_is_scipys_quintic_spline_of_the_same_end_conditions(count, slopes):
    rng = np.random.default_rng(count)
    x = np.cumsum(rng.uniform(0.05, 1, count))
    y = rng.normal(size=count)
    ends = ([(2, 0), (4, 0)],) * 2 if slopes is None else tuple([(1, slope), (2, 0)] for slope in slopes)
    at = np.linspace(x[0], x[-1], 200)
    expected = make_interp_spline(x, y, k=5, bc_type=ends)(at)
    assert np.max(np.abs(curve(hd.Table("lift", x, y, ("s", "m"), slopes), at) - expected)) < 1e-10 * np.max(
        np.abs(expected)
    )


def test_two_points_are_a_straight_line_and_units_are_those_of_the_table():
    assert curve(hd.Table("lift", (1, 3), (5, 9), ("s", "m")), np.array([1, 1.5, 3])) == pytest.approx(
        [5, 6, 9], rel=1e-15
    )
    table = hd.Table("lift", (0, 20, 40), (0, 5, 0), ("ms", "mm"), (100, 100))
    assert curve(table, np.array([0.02])) == pytest.approx([0.005], rel=1e-15)
    assert [row[2] for row in table.pieces()][::2] == pytest.approx([100, 100])  # mm/ms is m/s


def generated(*tables, **drive):
    """A block driven by tables, beside a free one."""
    block, other = (
        hd.Body("block", hd.Parameter("mass", "kg", 1.0)),
        hd.Body("other", hd.Parameter("other_mass", "kg", 1.0)),
    )
    joints = (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X), hd.Prismatic("free", hd.GROUND, other, axis=hd.Y))
    scales = hd.Scales(length=SIZE, speed=hd.Parameter("pace", "m/s", 1.0))
    return Derived(hd.Scene(hd.Mechanism("table", joints), (hd.Drive("drive", "slide", **drive), *tables), scales))


def motion(derived, t):
    """Position, speed and acceleration of the driven block: AD of its pose by time."""
    x = ca.SX.sym("t")
    place = ca.SX(derived.results("poses", {"t": x, "q": np.zeros(1)})[0])[0]
    speed = ca.jacobian(place, x)
    return [
        np.array(ca.Function("f", [x], [e]).map(len(t))(t[None, :])).ravel()
        for e in (place, speed, ca.jacobian(speed, x))
    ]


def sine(count):
    times = np.linspace(0, np.pi, count)
    return hd.Table("sine", times.tolist(), np.sin(times).tolist(), ("s", "m"))


@pytest.mark.parametrize(("order", "rate"), [(0, 6), (1, 5), (2, 4)])
def test_a_sine_is_met_to_the_order_of_quintic_splines(order, rate):
    """Halving the distance of the points divides the error by 2^6, of the speed by 2^5, of the acceleration by 2^4."""
    t = np.linspace(0, np.pi, 401)
    errors = []
    for count in (9, 17, 33):
        found = motion(generated(position=sine(count)(hd.T)), t)[order]
        errors.append(np.max(np.abs(found - np.sin(t + order * np.pi / 2))))
    assert [math.log2(a / b) for a, b in pairwise(errors)] == pytest.approx([rate] * 2, abs=0.3)


def test_beyond_the_table_it_goes_on_along_the_tangent():
    t = np.array([-2.0, -1e-9, np.pi + 1e-9, 5.0])
    place, speed, acceleration = motion(generated(position=sine(33)(hd.T)), t)
    slopes = [1, 1, -1, -1]
    assert speed == pytest.approx(slopes, abs=1e-7)
    assert place == pytest.approx([-2, 0, 0, np.pi - 5], abs=1e-6)
    assert np.all(np.abs(acceleration) < 1e-12)


def test_the_declared_derivatives_are_those_of_the_position():
    """The emitted derivatives of the table, which accelerations use, against AD of the emitted position."""
    t = np.linspace(-0.5, 3.5, 23)
    derived = generated(position=sine(9)(hd.T))
    x = ca.SX.sym("t")
    emitted = [derived.names["_spline"](derived.names["SINE_TABLE"], x)[order] for order in (0, 1, 2)]
    numbers = [np.array(ca.Function("f", [x], [e]).map(len(t))(t[None, :])).ravel() for e in emitted]
    for ours, by_ad in zip(numbers, motion(derived, t), strict=True):
        assert ours == pytest.approx(by_ad, abs=1e-14)


def test_a_table_stands_once_in_the_module_and_may_be_a_characteristic():
    derived = generated(position=sine(9)(hd.T))
    assert len(derived.SINE_TABLE) == 9
    assert derived.text.count("def _spline") == 1
    assert "_TABLE" not in generated(position=SIZE * sp.sin(hd.Parameter("w", "rad/s", 1) * hd.T)).text
    grip = hd.Table("grip", (-1, 0, 1), (-7, 0, 7), ("m", "N"))
    derived = generated(hd.JointForce("pull", "free", -grip(hd.coordinate_of("free"))), position=sine(9)(hd.T))
    assert derived.call("applied", t=0, q=[0.25], u=[0.0])[0] == pytest.approx(-1.75, rel=1e-12)


def test_it_is_written_as_a_function_of_two_derivatives():
    up_down = hd.Table("up_down", (0, 1), (0, 1), ("s", "m"))
    twice = SIZE * sp.diff(up_down(hd.T), hd.T, 2)
    assert text_of(twice) == str(twice) == "size*up_down''(t)"
    assert latex_of(up_down(hd.T)) == r"\mathrm{up\_down}\left(t\right)"
    with pytest.raises(ValueError, match="two derivatives"):
        sp.diff(sine(9)(hd.T), hd.T, 3)
    assert sp.diff(sine(9)(2 * hd.T), hd.T) == 2 * Spline(sine(9), 2 * hd.T, 1)


def test_text_is_no_argument_and_is_not_executed(tmp_path):
    """SymPy would execute it."""
    mark = tmp_path / "executed"
    text = f"__import__('pathlib').Path({str(mark)!r}).touch() or 1"
    with pytest.raises(TypeError, match="text"):
        hd.Table("lift", (0.0, 1.0), (0.0, 1.0), ("s", "m"))(text)
    for given in ((text, 1, 2), (sp.Symbol("x") > 0, text, 2), (sp.Symbol("x") > 0, 1, text)):
        with pytest.raises(TypeError, match="text"):
            Where(*given)
    assert not mark.exists()
