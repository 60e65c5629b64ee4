"""Closed loops against an independent saddle-point system: KanesMethod's open tree, constraints written by hand and differentiated numerically."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from derived import Derived
from kane import Tree, driven, random_tree

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate

TREES = {
    "four-bar": random_tree("R+Z R+Z R-Z", 41, planar=2),
    "of the last body to the first": random_tree("R+Z R+Z R+Z R+Z", 42, planar=2),
    "branches": random_tree("R+Z R+Z R+Z P+X R-Z", 43, parents=(-1, 0, 0, 1, 2), planar=2),
    "driven": driven(random_tree("R+Z R+Z R+Z R-Z", 44, planar=2), 0, 2.5),
}
ENDS = {"four-bar": (2, -1), "of the last body to the first": (3, 0), "branches": (4, 3), "driven": (3, -1)}


class Closed:
    """A planar tree closed between two bodies at one state, and what must hold there."""

    def __init__(self, tree: Tree, child: int, parent: int, kind: str, q: np.ndarray, u: np.ndarray) -> None:
        self.tree, self.child, self.parent, self.kind = tree, child, parent, kind
        rng = np.random.default_rng(3)
        self.on_child = np.append(rng.uniform(-0.5, 0.5, 2), 0.0)
        origin, turn = tree.pose(parent, q)
        self.on_parent = turn.T @ (tree.point(child, self.on_child, q) - origin)  # closed at q
        self.angle = self._angle(q)
        self.q = q
        self.u = self._held(q, u)

    def _angle(self, q):
        (_, one), (_, two) = self.tree.pose(self.child, q), self.tree.pose(self.parent, q)
        relative = two.T @ one
        return np.arctan2(relative[1, 0], relative[0, 0])

    def phi(self, q):
        """The two points apart, ground axes; or, of a slide along the parent's x: the way across it, and the sine of the angle between."""
        apart = self.tree.point(self.child, self.on_child, q) - self.tree.point(self.parent, self.on_parent, q)
        if self.kind == "R":
            return apart[:2]
        (_, one), (_, two) = self.tree.pose(self.child, q), self.tree.pose(self.parent, q)
        return np.array([two[:, 1] @ apart, (two.T @ one)[1, 0]])

    def jacobian(self, q):
        n = len(q)
        return np.array([self.phi(q.astype(complex) + 1e-30j * np.eye(n)[i]).imag / 1e-30 for i in range(n)]).T

    def bias(self, q, u):
        """Second derivative of phi along q + u t, by central differences of the Jacobian."""
        h = 1e-6
        return (self.jacobian(q + h * u) - self.jacobian(q - h * u)) @ u / (2 * h)

    def _held(self, q, u):
        """Speeds that keep the loop closed, nearest to u among the free ones; the drives keep theirs."""
        G, free = self.jacobian(q), self.tree.free
        u = u.copy()
        u[free] -= np.linalg.lstsq(G[:, free], G @ u, rcond=None)[0]
        return u

    @property
    def scene(self) -> hd.Scene:
        scene = self.tree.scene()
        bodies = (hd.GROUND, *self.tree.bodies)
        places = [
            bodies[i + 1].at(
                *(hd.Parameter(f"{n}{k}", "m", float(v)) if v else 0 for k, v in zip("xyz", local, strict=True))
            )
            for n, i, local in (("on_parent", self.parent, self.on_parent), ("on_child", self.child, self.on_child))
        ]
        joint = hd.Revolute("closing", *places, hd.Z) if self.kind == "R" else hd.Prismatic("closing", *places, hd.X)
        return replace(scene, mechanism=replace(scene.mechanism, joints=(*scene.mechanism.joints, joint)))


def closed(name: str, kind: str) -> Closed:
    tree, (child, parent) = TREES[name], ENDS[name]
    rng = np.random.default_rng(7)
    n = len(tree.links)
    t = 0.3
    q, u = tree.whole(t, rng.uniform(-1, 1, n)[tree.free], False), tree.whole(t, rng.uniform(-2, 2, n)[tree.free], True)
    if kind == "P":  # a slide holds the angle: turn the child until it is parallel to the parent
        last = next(i for i in reversed(tree.free) if tree.links[i].kind == "R" and _carries(tree, i, child))
        q[last] -= (1 if tree.links[last].axis[0] == "+" else -1) * Closed(tree, child, parent, "R", q, u).angle
    return Closed(tree, child, parent, kind, q, u)


def _carries(tree: Tree, link: int, body: int) -> bool:
    while body >= 0:
        if body == link:
            return True
        body = tree.links[body].parent
    return False


CASES = [(name, kind) for name in TREES for kind in "RP"]


@pytest.mark.by_turns(3)
@pytest.mark.parametrize(("name", "kind"), CASES)
def test_accelerations_multipliers_and_reactions_solve_the_saddle_point_system(name, kind):
    case = closed(name, kind)
    tree, free = case.tree, case.tree.free
    found = Derived(case.scene)
    q, u, t = case.q[free], case.u[free], 0.3
    force = np.random.default_rng(1).uniform(-3, 3, len(tree.links))
    order = [*free, *tree.driven]
    mass, forcing = tree.mass_and_forcing(case.q, case.u)
    G, gamma = case.jacobian(case.q), case.bias(case.q, case.u)
    n, right = len(free), (forcing + force)
    saddle = np.block([[mass[np.ix_(free, free)], -G[:, free].T], [G[:, free], np.zeros((2, 2))]])
    solved = np.linalg.solve(saddle, np.concatenate([right[free], -gamma]))
    applied = found.call("applied", t=t, q=q, u=u)
    a, reactions, multipliers = found.call("accelerations", t=t, q=q, u=u, f=applied + force[order])
    assert a == pytest.approx(solved[:n], rel=1e-7, abs=1e-7)
    assert multipliers == pytest.approx(solved[n:], rel=1e-7, abs=1e-7)
    drives = tree.driven
    wanted = mass[np.ix_(drives, free)] @ solved[:n] - right[drives] - G[:, drives].T @ solved[n:]
    assert reactions == pytest.approx(wanted, rel=1e-7, abs=1e-7)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(("name", "kind"), CASES)
def test_constraints_their_rates_and_the_projection(name, kind):
    case = closed(name, kind)
    free = case.tree.free
    actual = Derived(case.scene)
    q, u, t = case.q[free], case.u[free], 0.3
    phi, rate = actual.call("constraints", t=t, q=q, u=u)
    assert phi == pytest.approx(np.zeros(2), abs=1e-14)
    assert rate == pytest.approx(np.zeros(2), abs=1e-13)
    shifted = case.q + np.where(np.isin(np.arange(len(case.q)), free), 0.01, 0.0)
    assert actual.call("constraints", t=t, q=shifted[free], u=u)[0] == pytest.approx(case.phi(shifted), abs=1e-13)
    pushed, independence = actual.call("projection", t=t, q=q, wanted=[0.3, -0.2])
    G = case.jacobian(case.q)[:, free]
    assert G @ pushed == pytest.approx([0.3, -0.2], rel=1e-9)
    mass, _ = case.tree.mass_and_forcing(case.q, case.u)
    inverse = np.linalg.inv(mass[np.ix_(free, free)])
    least = (
        inverse @ G.T @ np.linalg.solve(G @ inverse @ G.T, [0.3, -0.2])
    )  # of all with that effect, least in kinetic energy
    assert pushed == pytest.approx(least, rel=1e-7, abs=1e-9)
    seen = (
        G @ inverse @ G.T
    )  # what elimination leaves, multiplied, is its determinant; the two of a hinge are one group
    sizes = np.trace(seen) ** 2 if kind == "R" else np.prod(np.diag(seen))
    assert np.prod(independence) == pytest.approx(np.linalg.det(seen) / sizes, rel=1e-6)


def test_a_redundant_loop_is_no_obstacle():
    """Two hinges on one axis: the second loop says what the first does; each bears half of the force."""
    case = closed("four-bar", "R")
    twice = case.scene.mechanism.joints[-1]
    again = hd.Revolute("again", twice.parent, twice.child, hd.Z)
    scene = replace(case.scene, mechanism=hd.Mechanism("tree", (*case.scene.mechanism.joints, again)))
    once, both = Derived(case.scene), Derived(scene)
    options = {"t": 0.3, "q": case.q, "u": case.u, "f": np.array([1.0, -2.0, 0.5])}
    (a, _, force), (a2, _, forces) = once.call("accelerations", **options), both.call("accelerations", **options)
    assert a2 == pytest.approx(a, rel=1e-7)
    assert forces == pytest.approx(np.tile(force / 2, 2), rel=1e-5)


def test_a_loop_that_cannot_be_closed_is_refused():
    case = closed("four-bar", "R")
    joint = case.scene.mechanism.joints[-1]
    off = hd.Revolute(
        "closing", joint.parent, joint.child.body.at(*joint.child.position[:2], hd.Parameter("off", "m", 0.1)), hd.Z
    )
    scene = replace(case.scene, mechanism=hd.Mechanism("tree", (*case.scene.mechanism.joints[:-1], off)))
    with pytest.raises(InputError, match=r"closing\.apart_z = off, whatever the motion"):
        Derived(scene)


TILT = hd.Parameter("tilt", "deg", 25)


def test_a_four_bar_in_a_tilted_plane_closes_as_triangles_require():
    """Across the plane no constraint is left; that it vanishes shows by numbers alone: cos sin - sin cos."""
    base, a, b, c = (hd.Parameter(name, "m", value) for name, value in zip("dabc", (0.3, 0.1, 0.3, 0.25), strict=True))
    crank, coupler, rocker = (
        hd.Body.rod(name, length, mass=hd.Parameter(f"m_{name}", "kg", 1), centre=(length / 2, 0, 0))
        for name, length in (("crank", a), ("coupler", b), ("rocker", c))
    )
    axis = hd.Direction((0, -sp.sin(TILT), sp.cos(TILT)))
    joints = (
        hd.Revolute("main", hd.GROUND, crank, axis), hd.Revolute("pin", crank.at(a, 0, 0), coupler, axis),
        hd.Revolute("bearing", hd.GROUND.at(base, 0, 0), rocker, axis), hd.Revolute("last", coupler.at(b, 0, 0), rocker.at(c, 0, 0), axis),
    )  # fmt: skip
    scene = hd.Scene(
        hd.Mechanism("four_bar", joints), (hd.ConstantSpeed("drive", "main", hd.Parameter("speed", "rad/s", 30)),),
        hd.Scales(length=a, speed=hd.Parameter("pace", "m/s", 3), arm=a), hd.Start(near={"bearing": hd.Parameter("open", "rad", 1.8)}),
    )  # fmt: skip
    assert not any("turned" in name for name, *_ in Derived(scene).CONSTRAINTS)
    run = simulate(scene, duration="0.1 s", tolerance=1e-8)
    reach = 0.1 * np.exp(3j) - 0.3  # from the bearing to the crank pin; then by the law of cosines
    corner = np.arccos((abs(reach) ** 2 + 0.25**2 - 0.3**2) / (2 * abs(reach) * 0.25))
    assert run["bearing.angle"][-1] == pytest.approx(np.angle(reach) - corner, abs=1e-6)


def guides(axis, turn, offset):
    """A belt and a block on parallel guides, and a third guide between them."""
    belt, block = (hd.Body(name, hd.Parameter(f"m_{name}", "kg", 1)) for name in ("belt", "block"))
    fixed = (hd.GROUND.at(0, y, 0).turned(hd.Z, turn) for y in (0, offset))
    joints = hd.Prismatic("run", next(fixed), belt, axis), hd.Prismatic("slide", next(fixed), block, axis)
    pace = hd.Parameter("pace", "m/s", 0.1)
    mechanism = hd.Mechanism("guides", (*joints, hd.Prismatic("rub", belt, block, axis)))
    return hd.Scene(mechanism, (), hd.Scales(length=hd.Parameter("size", "m", 0.1), speed=pace))


@pytest.mark.parametrize("way", [(hd.X, TILT), (hd.Direction((sp.cos(TILT), sp.sin(TILT), 0)), 0)])
def test_parallel_guides_along_a_tilted_axis_leave_no_constraint(way):
    assert not Derived(guides(*way, 0)).CONSTRAINTS
    with pytest.raises(InputError, match=r"rub\.off_\w other than 0, whatever the motion"):
        Derived(guides(*way, hd.Parameter("offset", "mm", 1)))


def test_faults_of_closing_joints_come_all_at_once():
    case = closed("four-bar", "R")
    scene, joint = case.scene, case.scene.mechanism.joints[-1]
    free = hd.Free("loose", joint.parent, joint.child)
    speed = hd.Parameter("pace_in", "rad/s", 1.0)
    with pytest.raises(InputError) as error:
        replace(
            scene, mechanism=replace(scene.mechanism, joints=(*scene.mechanism.joints, free)),
            effects=(*scene.effects, hd.ConstantSpeed("drive", "closing", speed)),
            start=hd.Start(position={"closing": hd.Parameter("turn_in", "rad", 0.1)}),
        )  # fmt: skip
    actual = {fault.where: fault for fault in error.value.faults}
    assert "free joint" in actual["joint loose"].found
    assert actual["effect drive"].found == "joint 'closing', which closes a loop"
    assert "declare this one before" in actual["effect drive"].remedy
    assert "closes a loop, its motion follows" in actual["start"].found
