"""Reactions of loops with redundant constraints: tree and absolute coordinates differ by a self-stress, and by nothing else.

Constraint forces that leave every body at rest are the null space of the transposed constraint Jacobian: what is
redundant. Here it is made from the places and axes of the joints alone, by statics.
"""

from importlib import import_module

import numpy as np
import pytest

from hertzwerk.derive.expressions.parameter import default_value
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.model.derived_histories import readings_of

pytestmark = pytest.mark.exhaustive  # half a minute each: readings of both coordinates are derived
ALONG = "xyz"


def frames(run):
    """Rotation of every body at the end, by its name, that of the ground included."""
    model = run.engine.model
    q = run.engine.history.part("y")[-1, : model.nq]
    matrices = model.evaluate("poses", run.t[-1], q, model.bind().c)[1].reshape(-1, 3, 3)
    return {"ground": np.eye(3), **dict(zip(model.module.BODIES, matrices, strict=True))}


def end(run, name):
    """Value at the end; 0 of what is zero by structure, and no history."""
    return run[name][-1] if name in readings_of(run.engine.model).rows else 0.0


def of_joints(run, joints):
    """Place, axis, and whether it slides, of every joint at the end."""
    turned = frames(run)
    for joint in joints:
        place = np.array([end(run, f"{joint.name}.child.{x}") for x in ALONG])
        (freedom,) = joint.freedoms
        axis = turned[joint.parent.body.name] @ [default_value(x) for x in freedom.axis.unit]
        yield place, axis, freedom.kind == "slide"


def self_stresses(run, joints):
    """Orthonormal self-stresses (6 joints, n), and the map (6 bodies, 6 joints) of wrenches of joints to those on bodies."""
    bodies = list(dict.fromkeys(joint.child.body.name for joint in joints))
    on_bodies, allowed = np.zeros((6 * len(bodies), 6 * len(joints))), []
    for k, (joint, (place, axis, slides)) in enumerate(zip(joints, of_joints(run, joints), strict=True)):
        x, y, z = place
        arm = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        wrench = np.block([[np.eye(3), np.zeros((3, 3))], [arm, np.eye(3)]])  # about the origin
        for sign, body in ((1, joint.child.body.name), (-1, joint.parent.body.name)):
            if body in bodies:
                row = 6 * bodies.index(body)
                on_bodies[row : row + 6, 6 * k : 6 * k + 6] = sign * wrench
        across = np.linalg.svd(axis[None])[2][1:].T
        whole = np.zeros((6, 5))
        whole[:3, :3], whole[3:, 3:] = np.eye(3), across
        if slides:
            whole = np.zeros((6, 5))
            whole[:3, :2], whole[3:, 2:] = across, np.eye(3)
        column = np.zeros((6 * len(joints), 5))
        column[6 * k : 6 * k + 6] = whole
        allowed.append(column)
    basis = np.hstack(allowed)
    _, sizes, directions = np.linalg.svd(on_bodies @ basis)
    rank = int(np.sum(sizes > 1e-9 * sizes[0]))
    return basis @ directions[rank:].T, on_bodies


def wrenches(run, joints):
    """Forces and moments (6 joints,) that the joints hold their children with at the end."""
    requested = [f"{joint.name}.reaction{what}_{x}" for joint in joints for what in ("", "_moment") for x in ALONG]
    return np.array([end(run, name) for name in requested])


@pytest.mark.parametrize(("name", "redundant"), [("bricard", 1), ("flyball_governor", 6)])
def test_reactions_differ_by_a_self_stress(name, redundant):
    joints = import_module(f"hertzwerk.derive.scenes.{name}").scene.mechanism.joints
    tree, absolute = (
        simulate(load(name, coordinates=kind), duration="30 ms", tolerance=1e-11, compiled=False)
        for kind in ("tree", "absolute")
    )
    stresses, on_bodies = self_stresses(tree, joints)
    assert stresses.shape[1] == redundant
    one, other = (wrenches(run, joints) for run in (tree, absolute))
    difference, size = one - other, np.abs(one).max()
    assert np.abs(difference).max() > 1e-3 * size  # they do differ
    assert np.abs(on_bodies @ difference).max() <= 1e-6 * size  # and no body feels it
    assert np.abs(difference - stresses @ (stresses.T @ difference)).max() <= 1e-6 * size
    determined = one - stresses @ (stresses.T @ one)
    assert determined == pytest.approx(other - stresses @ (stresses.T @ other), abs=1e-6 * size)
    for k in range(0, len(one), 7):  # a force more in one of them is no self-stress
        wrong = difference + 1e-3 * size * (np.arange(len(one)) == k)
        assert np.abs(wrong - stresses @ (stresses.T @ wrong)).max() > 1e-5 * size
