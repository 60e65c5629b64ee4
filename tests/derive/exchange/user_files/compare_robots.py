"""Compare the robots of a folder of URDF files with Pinocchio: python compare_robots.py FOLDER [--only TEXT]

`pip install pin` first. Of each file, fixed and floating: mass matrix and accelerations at random states, and the
accelerations of joints that mimic others by projection. Joints that move nothing are locked, impossible inertias are
the nearest possible ones, in both programs; the table says where. Nothing is written.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path
from xml.etree import ElementTree

import casadi as ca
import numpy as np
import pinocchio as pin
from scipy.spatial.transform import Rotation

from hertzwerk.derive import Direction, EnergyLedger, Gravity, InputError, Parameter, Scales, from_urdf
from hertzwerk.runtime import load

SCALES = Scales(*(Parameter(f"scale_of_{name}", unit, 1) for name, unit in (("length", "m"), ("speed", "m/s"))),
                arm=Parameter("scale_of_arms", "m", 1))  # fmt: skip
DOWN = (1, 2, -2)  # robots may lie on their side
GRAVITY = Gravity("gravity_of_the_world", Parameter("gravity_of_the_world_g", "m/s^2", 9.81), direction=Direction(DOWN))
STATES = 3


def massless_joints(model):
    """Names of joints beyond which Pinocchio finds no inertia."""
    heavy = {0}
    for i in reversed(range(1, model.njoints)):
        if np.abs(model.inertias[i].matrix()).max() > 0 or any(model.parents[k] == i for k in heavy):
            heavy.add(i)
    return [model.names[i] for i in range(1, model.njoints) if i not in heavy]


def with_inertias(path, robot, base):
    """Text of a file, with the inertias that hertzwerk took for the nearest possible ones."""
    root = ElementTree.parse(path).getroot()
    for repair in robot.repairs:
        if repair.startswith("inertia of "):
            name = repair.removeprefix("inertia of ").split(",")[0]
            link = next(link for link in root.iter("link") if link.get("name") == name)
            inertial = link.find("inertial")
            if (origin := inertial.find("origin")) is not None:
                origin.set("rpy", "0 0 0")
            rows = robot.bodies[name].tensor
            for i, k in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                value = rows[i][k]
                inertial.find("inertia").set(f"i{'xyz'[i]}{'xyz'[k]}", repr(float(getattr(value, "si", value))))
    for mimic in list(root.iter("joint")):  # Pinocchio would take none of a joint that is fixed
        for element in mimic.findall("mimic"):
            mimic.remove(element)
    return ElementTree.tostring(root, encoding="unicode")


def read(path, base):
    """Robot of a file, and what it took to read it."""
    model = pin.buildModelFromUrdf(str(path), *([pin.JointModelFreeFlyer()] if base == "floating" else []))
    locked = dict.fromkeys((name for name in massless_joints(model) if name != "root_joint"), 0)
    for how in ({}, {"locked": locked}, {"inertia": "nearest"}, {"locked": locked, "inertia": "nearest"}):
        try:
            robot = from_urdf(path, base, **how)
            robot.scene(GRAVITY, scales=SCALES)
            return robot, how
        except InputError as error:
            last = error
    raise last


def theirs(path, robot, base, locked):
    """Pinocchio's model, and its joint for each moving child link."""
    with tempfile.NamedTemporaryFile("w", suffix=".urdf") as file:
        file.write(with_inertias(path, robot, base))
        file.flush()
        model = pin.buildModelFromUrdf(file.name, *([pin.JointModelFreeFlyer()] if base == "floating" else []))
    if locked:
        ids = [model.getJointId(name) for name in locked]
        model = pin.buildReducedModel(model, ids, pin.neutral(model))
    return model


def state_of(model, robot, path, base, q, u):
    """Their coordinates and speeds of ours, and the matrix between the speeds."""
    links = {
        j.get("name"): j.find("child").get("link")
        for j in ElementTree.parse(path).getroot().iter("joint")
        if j.find("child") is not None
    }
    keys, places, rows = {}, 0, 0
    for freedom in robot.mechanism.freedoms:
        keys[freedom.key] = (places, rows)
        places, rows = places + len(freedom.coordinates), rows + len(freedom.speeds)
    qs, S = np.zeros(model.nq), np.zeros((model.nv, rows))
    for i in range(1, model.njoints):
        joint, name = model.joints[i], model.names[i]
        if name == "root_joint":
            turn = Rotation.from_quat(np.roll(q[3:7], -1)).as_matrix()
            qs[:7] = *q[:3], *np.roll(q[3:7], -1)
            S[:3, :3], S[3:6, 3:6] = turn.T, np.eye(3)
            continue
        place, row = keys[robot.mechanism.joint_of(robot.bodies[links[name]]).name]
        qs[joint.idx_q : joint.idx_q + joint.nq] = q[place] if joint.nq == 1 else (np.cos(q[place]), np.sin(q[place]))
        S[joint.idx_v, row] = 1
    return qs, S @ u, S


def compare(path, base):
    """How a file is read, and the largest relative differences of mass matrix and forces of inertia."""
    robot, how = read(path, base)
    model = theirs(path, robot, base, how.get("locked", ()))
    model.gravity.linear = 9.81 / 3 * np.array(DOWN)
    data = model.createData()
    ours = load(robot.scene(GRAVITY, EnergyLedger(), scales=SCALES).without(*(effect.name for effect in robot.effects)))
    energy, accelerations, applied, c = (*map(ours.function, ("energy", "accelerations", "applied")), ours.bind().c)
    n = sum(len(freedom.speeds) for freedom in robot.mechanism.freedoms)
    speeds, q_ = (
        ca.SX.sym("u", n),
        ca.SX.sym("q", sum(len(freedom.coordinates) for freedom in robot.mechanism.freedoms)),
    )
    matrix = ca.Function("M", [q_, speeds], [ca.hessian(energy(0, q_, speeds, c)[0], speeds)[0]])
    assert model.nv == n, (model.nv, n)
    rng, worst = np.random.default_rng(1), [0.0, 0.0, 0.0]
    for _ in range(STATES):
        q, u = rng.uniform(-1, 1, q_.numel()), rng.normal(size=n)
        if base == "floating":
            q[3:7] /= np.linalg.norm(q[3:7])
        qs, us, S = state_of(model, robot, path, base, q, u)
        M = pin.crba(model, data, qs)
        M = S.T @ (np.triu(M) + np.triu(M, 1).T) @ S
        worst[0] = max(worst[0], np.abs(np.array(matrix(q, u)) - M).max() / np.abs(M).max())
        a = np.array(accelerations(0, q, u, applied(0, q, u, c), c)[0]).ravel()
        expected = pin.aba(model, data, qs, us, np.zeros(model.nv))
        if base == "floating":  # d(R^T v)/dt = R^T v' - w x R^T v
            expected[:3] += np.cross(us[3:6], us[:3])
        expected = np.linalg.solve(S, expected)
        worst[1] = max(worst[1], np.abs(M @ (a - expected)).max() / np.abs(M @ a).max())
        worst[2] = max(worst[2], np.abs(a - expected).max() / np.abs(a).max())
    return robot, how, n, worst


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--base", default="")
    given = arguments.parse_args()
    for path in sorted(given.folder.rglob("*.urdf")):
        if given.only not in str(path):
            continue
        for base in ("fixed", "floating"):
            if given.base not in base:
                continue
            begun = time.process_time()
            try:
                robot, how, n, worst = compare(path, base)
                print(f"{path.name:40} {base:9} {n:4} freedoms  " + "  ".join(f"{value:.1e}" for value in worst),
                      f"{time.process_time() - begun:5.0f} s", how, len(robot.repairs), "repairs", flush=True)  # fmt: skip
            except (InputError, ValueError, RuntimeError, AssertionError) as error:
                print(f"{path.name:40} {base:9} {type(error).__name__}: {str(error)[:600]}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
