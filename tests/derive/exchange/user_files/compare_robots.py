"""Compare the robots of a folder of URDF files with Pinocchio: python compare_robots.py FOLDER [--only TEXT] [--exact]

`pip install pin` first. Of each file, fixed and floating, at random states: the mass matrix, the forces that the
difference of accelerations takes (relative to all), the accelerations, and with joints that mimic others the forces
again, theirs by projection. With --exact, accelerations of both programs against 50 digits, and how much these change
with the last digit of the data. Joints that move nothing are locked and impossible inertias are the nearest possible ones,
in both programs, where a file is refused without: the table says so. Nothing is written.
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
from exact_accelerations import Exact
from scipy.spatial.transform import Rotation

from hertzwerk.derive import Coupling, Direction, EnergyLedger, Gravity, InputError, Parameter, Scales, from_urdf
from hertzwerk.runtime.loading import engine_model

SCALES = Scales(
    Parameter("scale_of_lengths", "m", 1), Parameter("scale_of_speeds", "m/s", 1), arm=Parameter("scale_of_arms", "m", 1),
)  # fmt: skip
DOWN = (1, 2, -2)  # robots may lie on their side
GRAVITY = Gravity("weight", Parameter("gravity_of_the_world", "m/s^2", 9.81), direction=Direction(DOWN))
STATES = 3


def model_of(path, base):
    """Pinocchio's model of a file."""
    return pin.buildModelFromUrdf(str(path), *([pin.JointModelFreeFlyer()] if base == "floating" else []))


def massless(model):
    """Names of joints beyond which Pinocchio finds no inertia."""
    heavy = {0}
    for i in reversed(range(1, model.njoints)):
        if np.abs(model.inertias[i].matrix()).max() > 0 or any(model.parents[k] == i for k in heavy):
            heavy.add(i)
    return [model.names[i] for i in range(1, model.njoints) if i not in heavy]


def read(path, base):
    """Robot of a file, and the options that it takes."""
    locked = dict.fromkeys(massless(model_of(path, base)), 0)
    for options in ({}, {"locked": locked}, {"inertia": "nearest"}, {"locked": locked, "inertia": "nearest"}):
        try:
            robot = from_urdf(path, base, **options)
            robot.scene(GRAVITY, scales=SCALES)
            return robot, options
        except InputError as error:
            refused = error
    raise refused


class Theirs:
    """A robot in Pinocchio: its state and equations in hertzwerk's coordinates and speeds."""

    def __init__(self, path, robot, base, options):
        root = ElementTree.parse(path).getroot()
        for repair in robot.repairs:
            if repair.startswith("impossible inertia of "):
                self._replace_inertia(root, robot, repair.removeprefix("impossible inertia of ").split(",")[0])
        with tempfile.NamedTemporaryFile("w", suffix=".urdf") as file:
            file.write(ElementTree.tostring(root, encoding="unicode"))
            file.flush()
            self.model = model_of(file.name, base)
        if locked := [self.model.getJointId(name) for name in options.get("locked", ())]:
            self.model = pin.buildReducedModel(self.model, locked, pin.neutral(self.model))
        self.model.gravity.linear = 9.81 / 3 * np.array(DOWN)
        self.data, self.floating, self.places = self.model.createData(), base == "floating", {}
        place = row = 0
        for freedom in robot.mechanism.freedoms:
            self.places[freedom.key] = (place, row)
            place, row = place + len(freedom.coordinates), row + len(freedom.speeds)
        self.sizes = place, row
        links = {joint.get("name"): joint.find("child").get("link") for joint in root.findall("joint")}
        self.keys = [
            robot.mechanism.joint_of(robot.bodies[links[name]]).name if name in links else ""
            for name in self.model.names
        ]

    @staticmethod
    def _replace_inertia(root, robot, name):
        inertial = next(link for link in root.findall("link") if link.get("name") == name).find("inertial")
        if (origin := inertial.find("origin")) is not None:
            origin.set("rpy", "0 0 0")
        for i, k in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
            value = robot.bodies[name].tensor[i][k]
            inertial.find("inertia").set(f"i{'xyz'[i]}{'xyz'[k]}", repr(float(getattr(value, "si", value))))

    def at(self, q, u):
        """Mass matrix and force of all but accelerations, in hertzwerk's speeds, and its accelerations."""
        model, data = self.model, self.data
        qs, us, S, still = self.state(q, u)
        M = pin.crba(model, data, qs)
        M = S.T @ (np.triu(M) + np.triu(M, 1).T) @ S
        forces = S.T @ pin.rnea(model, data, qs, us, still)
        return M, forces, np.linalg.solve(S, pin.aba(model, data, qs, us, np.zeros(model.nv)) - still)

    def exact(self, q, u, random=None):
        """Accelerations in hertzwerk's speeds, in 50 digits."""
        qs, us, S, still = self.state(q, u)
        return np.linalg.solve(S, np.array(Exact(self.model, random).accelerations(qs, us)) - still)

    def state(self, q, u):
        """Coordinates and speeds in Pinocchio's, the matrix between the speeds, and its part of accelerations."""
        model = self.model
        qs, S = np.zeros(model.nq), np.zeros((model.nv, len(u)))
        for joint, key in list(zip(model.joints, self.keys, strict=True))[1:]:
            if not key:  # the free base: a quaternion with its scalar last, speeds in its own axes
                turn = Rotation.from_quat(np.roll(q[3:7], -1)).as_matrix()
                qs[:7] = *q[:3], *np.roll(q[3:7], -1)
                S[:3, :3], S[3:6, 3:6] = turn.T, np.eye(3)
                continue
            place, row = self.places[key]
            qs[joint.idx_q : joint.idx_q + joint.nq] = (
                q[place] if joint.nq == 1 else (np.cos(q[place]), np.sin(q[place]))
            )
            S[joint.idx_v, row] = 1
        us, still = S @ u, np.zeros(model.nv)
        if self.floating:  # d(R^T v)/dt = R^T v' - w x R^T v
            still[:3] = -np.cross(us[3:6], us[:3])
        return qs, us, S, still


def followed(couplings, places, q, size):
    """Coordinates with those of followers, and the matrix that gives all speeds by those that follow none."""
    q, G = q.copy(), np.eye(size)
    for _ in couplings:  # a follower may follow a follower
        for each in couplings:
            (place, row), (leader, other) = places[each.first], places[each.second]
            ratio, offset = (float(getattr(value, "si", value)) for value in (each.ratio, each.offset))
            q[place], G[row] = ratio * q[leader] + offset, ratio * G[other]
    followers = {places[each.first][1] for each in couplings}
    return q, G[:, [row for row in range(size) if row not in followers]]


def compare(path, base, exact=False):
    """Options of a file, number of its speeds, largest relative differences, and number of repairs."""
    robot, options = read(path, base)
    theirs = Theirs(path, robot, base, options)
    couplings = [effect for effect in robot.effects if isinstance(effect, Coupling)]
    names, kept = [effect.name for effect in robot.effects], [effect.name for effect in couplings]
    scene = robot.scene(GRAVITY, EnergyLedger(), scales=SCALES)
    model = engine_model(scene.without(*names))
    coupled = engine_model(scene.without(*(name for name in names if name not in kept))) if couplings else None
    place, size = theirs.sizes
    assert theirs.model.nv == size, f"{theirs.model.nv} speeds there, {size} here"
    q, u = ca.SX.sym("q", place), ca.SX.sym("u", size)
    energy = model.function("energy")(0, q, u, model.bind().c)[0]
    matrix = ca.Function("M", [q, u], [ca.hessian(energy, u)[0]])
    rng, worst = np.random.default_rng(1), np.zeros(4)
    for _ in range(STATES):
        q, u = rng.uniform(-1, 1, place), rng.normal(size=size)
        if base == "floating":
            q[3:7] /= np.linalg.norm(q[3:7])
        M, forces, expected = theirs.at(q, u)
        a = accelerations(model, q, u)
        actual = [np.abs(np.array(matrix(q, u)) - M).max() / np.abs(M).max(), share(M, a, expected),
                 np.abs(a - expected).max() / np.abs(a).max(), 0]  # fmt: skip
        if exact:
            true, altered = theirs.exact(q, u), theirs.exact(q, u, np.random.default_rng(2))
            errors = [np.abs(each - true).max() / np.abs(true).max() for each in (a, expected, altered)]
            print(
                f"    error here {errors[0]:.1e}, there {errors[1]:.1e}; by the last digit of the data {errors[2]:.1e}"
            )
        if coupled is not None:
            q, G = followed(couplings, theirs.places, q, size)
            u = G @ np.linalg.lstsq(G, u, rcond=None)[0]
            M, forces, _ = theirs.at(q, u)
            actual[3] = share(M, accelerations(coupled, q, u), G @ np.linalg.solve(G.T @ M @ G, -G.T @ forces))
        worst = np.maximum(worst, actual)
    return options, size, worst, len(robot.repairs)


def accelerations(model, q, u):
    """Accelerations by a model, under its own forces."""
    c = model.bind().c
    return np.array(model.function("accelerations")(0, q, u, model.function("applied")(0, q, u, c), c)[0]).ravel()


def share(M, a, expected):
    """Largest force of a difference of accelerations, relative to the largest of them."""
    return np.abs(M @ (a - expected)).max() / np.abs(M @ a).max()


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--only", default="", help="files whose path contains this text")
    arguments.add_argument("--exact", action="store_true", help="compare with 50 digits too")
    given = arguments.parse_args()
    for path in sorted(path for path in given.folder.rglob("*.urdf") if given.only in str(path)):
        for base in ("fixed", "floating"):
            begun = time.process_time()
            try:
                options, size, worst, repairs = compare(path, base, given.exact)
            except (InputError, ValueError, AssertionError) as error:
                print(f"{path.name:36} {base:9} {type(error).__name__}: {error}", flush=True)
                continue
            taken = ", ".join(
                f"{name} {list(value) if isinstance(value, dict) else value}" for name, value in options.items()
            )
            numbers = "  ".join(f"{value:.1e}" for value in worst)
            seconds = time.process_time() - begun
            print(
                f"{path.name:36} {base:9} {size:4}  {numbers}  {repairs} repairs  {seconds:.0f} s  {taken}", flush=True
            )


if __name__ == "__main__":
    sys.exit(main())
