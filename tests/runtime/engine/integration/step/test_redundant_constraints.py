"""Redundant constraints: which ones they are, which are taken out for a step, what that is good for, and what it leaves as it was."""

from functools import cache

import casadi as ca
import numpy as np
from loops import cranks
from scipy.linalg import qr

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.step import redundant_constraints
from hertzwerk.runtime.engine.start.start_values import dependent, start_of
from hertzwerk.runtime.loading import engine_model

model = cache(engine_model)


def test_the_choice_is_that_of_a_pivoted_qr_factorisation():
    rng = np.random.default_rng(5)
    for _ in range(20):
        n, m, rank = rng.integers(2, 9), 7, rng.integers(1, 6)
        rank = min(rank, n - 1)
        rows = rng.normal(size=(n, rank)) @ rng.normal(size=(rank, m))
        kept = redundant_constraints._independent([ca.SX(row[None, :]) for row in rows], rank)
        chosen = np.flatnonzero([float(one) for one in kept])
        _, _, order = qr(rows.T, pivoting=True)
        assert sorted(chosen) == sorted(order[:rank])


def implied(model, initial=None):
    """Groups of constraints and their rank, from a start."""
    bound, q, _ = start_of(model, {}, initial or {})
    return dependent(model, bound, q)


def test_the_groups_and_how_many_of_them_count():
    """Five rods closed in space: Grübler counts 5 - 5 freedoms, there is 1. Each arm of the governor: one force across the plane that turns."""
    assert implied(model("bricard")) == (((0, 1, 2, 3, 4), 4),)
    governor = model("flyball_governor")
    groups = [[governor.constraints[i] for i in members] for members, _ in implied(governor)]
    assert groups == [[f"{side}_foot.apart_{k}" for k in "xz"] for side in ("right", "left")]
    assert [rank for _, rank in implied(governor)] == [1, 1]
    assert implied(engine_model(cranks())) == (((0, 1, 2, 3), 3),)


def test_a_singular_start_is_not_taken_for_redundancy():
    """Flat, the cranks' constraints have the rank 2, and two windows' the rank 2; elsewhere 3, and 4."""
    flat = {f"{name}.angle": (0.0, "rad") for name in ("first", "left", "second", "third")}
    turning = {f"{name}.speed": (1.0, "rad/s") for name in ("first", "second", "third")} | {
        "left.speed": (-1.0, "rad/s")
    }
    assert implied(engine_model(cranks()), flat | turning) == (((0, 1, 2, 3), 3),)
    windows = model("n_four_bar")
    ways = [(f"foot_{i}", -1.0) for i in range(3)] + [(f"left_{i}", 1.0) for i in range(2)]
    initial = {f"{name}.angle": (way * np.pi / 2, "rad") for name, way in ways}
    initial |= {f"{name}.speed": (way, "rad/s") for name, way in ways}
    run = simulate(windows, duration=1.0, tolerance=1e-10, initial=initial)
    assert any("leave forces undetermined" in warning for warning in run.warnings)  # there and then
    assert implied(windows, initial) == ()
    assert run.energy_residual < 1e-9


def test_bricard_keeps_its_energy():
    """With all constraints in the stages it loses 3e-5; the other methods, and the same bits as C, are a hard case."""
    assert simulate(model("bricard"), duration=10.0, tolerance=1e-9, method="dopri5").energy_residual < 6e-9


def test_the_constraint_taken_out_changes_on_the_way_and_the_rest_are_held_by_the_minimum_norm():
    """Of x and z at the governor's feet that which has less to say in the plane of the arms; either would be missing twice a turn."""
    groups = (((0, 2), 1), ((3, 5), 1))
    governor = model("flyball_governor").without_redundancy(groups)
    softness = redundant_constraints._softness(governor)
    run = simulate(model("flyball_governor"), duration=0.4, tolerance=1e-9)
    c, q = run.engine.history.controls[: governor.nc], run.engine.history.part("y")[:, : governor.nq]
    angle, free = run["spindle.angle"], np.ones(governor.nu)
    out = np.array([softness(0, row, c, free, 1.0).full().ravel() for row in q]) == redundant_constraints.OUT
    along_x = np.abs(np.cos(angle)) > np.abs(np.sin(angle))
    assert 0.3 < np.mean(along_x) < 0.7
    clear = np.abs(np.cos(2 * angle)) > 0.3
    for first, last in ((0, 2), (3, 5)):
        assert np.all(out[clear, last] == along_x[clear])
        assert np.all(out[:, first] != out[:, last])
    # The feet of the governor's rods: nothing across the plane of its arms, though a constraint that bears a part of it is taken out.
    assert np.ptp(angle) > np.pi
    for side in ("right", "left"):
        x, z = (run[f"{side}_foot.force_{k}"] for k in "xz")
        across, within = x * np.sin(angle) + z * np.cos(angle), x * np.cos(angle) - z * np.sin(angle)
        assert np.max(np.abs(across)) < 1e-5 * np.max(np.abs(within))


def test_where_nothing_is_redundant_nothing_changes():
    windows = model("n_four_bar")
    assert windows.without_redundancy(implied(windows)) is windows
    function = windows.function("accelerations")
    t, q, u, f, c = (ca.SX.sym(name, function.numel_in(i)) for i, name in enumerate("tqufc"))
    softness = c[windows.nc - windows.nl :]
    assert not any(ca.which_depends(function(t, q, u, f, c)[0], softness, 1, False))
    start, run = {"t": 0}, {"c": c}
    assert redundant_constraints.relax_redundant(windows)(start, run) is run
