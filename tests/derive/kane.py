"""Independent oracle: a tree of bodies given to sympy.physics.mechanics (KanesMethod), and the same tree as a hertzwerk scene.

The tree is described once, in a neutral record; nothing of hertzwerk's kinematics or equations is used on the oracle's side. Driven joints
stay free there: their speed is prescribed by putting it in and their row of M a - forcing is what the drive must supply.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
import sympy.physics.mechanics as me

import hertzwerk.derive as hd

TURNED = (("+X", 0.4), ("-Y", 0.7))
DIRECTIONS = {"+X": hd.X, "+Y": hd.Y, "+Z": hd.Z, "-X": -hd.X, "-Y": -hd.Y, "-Z": -hd.Z}


@dataclass(frozen=True)
class Link:
    """A body on its joint: `kind` (see JOINTS), axes, places on parent and child, mass, principal inertias, mass centre (SI numbers).

    axis     signed coordinate axis, or three numbers; of a universal joint `second` is its other one
    turned   the joint's axes on the parent and on the child: each about a signed axis by an angle, or None
    """

    kind: str
    axis: str | tuple[float, ...]
    parent: int  # index of a link, -1 for the ground
    on_parent: tuple[float, ...]
    on_child: tuple[float, ...]
    mass: float
    inertia: tuple[float, float, float]
    centre: tuple[float, ...]
    scalar: int | None = None  # declare only this component of the inertia, as a scalar
    speed: float | None = None  # driven at this speed
    second: str | tuple[float, ...] = "+Y"
    turned: tuple[tuple[str, float] | None, tuple[str, float] | None] = (None, None)

    @cached_property
    def moves(self) -> list[tuple[str, np.ndarray]]:
        """What the joint does, from the parent outwards: a turn R or a slide P along a unit vector, or a ball S."""
        axis, second = unit(self.axis), unit(self.second)
        k = int(np.argmax(np.abs(axis)))
        x, y, z = np.eye(3)
        return {
            "R": [("R", axis)], "P": [("P", axis)], "C": [("P", axis), ("R", axis)],
            "L": [("P", np.eye(3)[(k + 1) % 3]), ("P", np.eye(3)[(k + 2) % 3]), ("R", axis)], "U": [("R", axis), ("R", second)], "S": [("S", axis)],
            "F": [("P", x), ("P", y), ("P", z), ("S", axis)], "W": [],
        }[self.kind]  # fmt: skip

    @property
    def nq(self) -> int:
        return sum(4 if kind == "S" else 1 for kind, _ in self.moves)

    @property
    def nu(self) -> int:
        return sum(3 if kind == "S" else 1 for kind, _ in self.moves)

    def turns(self) -> list[np.ndarray]:
        """Rotations from the joint's axes to those of the parent and of the child."""
        return [
            np.eye(3) if turn is None else rodrigues(unit(turn[0]), np.cos(turn[1]), np.sin(turn[1]))
            for turn in self.turned
        ]


JOINTS = {
    "R": hd.Revolute, "P": hd.Prismatic, "C": hd.Cylindrical, "L": hd.Planar, "U": hd.Universal, "S": hd.Spherical,
    "F": hd.Free, "W": hd.Weld,
}  # fmt: skip


def unit(axis: str | Sequence[float]) -> np.ndarray:
    """The unit vector of a signed axis or of three numbers."""
    if isinstance(axis, str):
        return np.eye(3)["XYZ".index(axis[1])] * (1 if axis[0] == "+" else -1)
    return np.asarray(axis) / np.linalg.norm(axis)


def rodrigues(axis: np.ndarray, cosine: Any, sine: Any) -> np.ndarray:
    """Rotation about a unit vector; complex numbers too."""
    x, y, z = axis
    tilde = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) * cosine + tilde * sine + np.outer(axis, axis) * (1 - cosine)


@dataclass(frozen=True)
class Tree:
    """A mechanism, its gravity, and the two ways to its equations.

    Coordinates and speeds of all joints stand one after another, link by link; `free` and `driven` are indices of speeds.
    """

    links: tuple[Link, ...]
    gravity: float = 9.81
    down: str = "-Y"

    # -- hertzwerk -------------------------------------------------------------------------------------------------

    @cached_property
    def bodies(self) -> list[hd.Body]:
        bodies = []
        for i, link in enumerate(self.links):
            inertia = (
                tuple(_quantity(f"J{i}{k}", "kg m^2", value) for k, value in zip("xyz", link.inertia, strict=True))
                if link.scalar is None
                else _quantity(f"J{i}", "kg m^2", link.inertia[link.scalar])
            )
            bodies.append(
                hd.Body(f"body{i}", _quantity(f"m{i}", "kg", link.mass), inertia, _place(f"s{i}", link.centre))
            )
        return bodies

    def scene(self, *contacts: hd.Contact | hd.Friction, pairs: Sequence[Any] = (), ledger: bool = True) -> hd.Scene:
        """The scene; `pairs` and their effects may be added."""
        joints = []
        for i, link in enumerate(self.links):
            parent = hd.GROUND if link.parent < 0 else self.bodies[link.parent]
            places = [parent.at(*_place(f"a{i}", link.on_parent)), self.bodies[i].at(*_place(f"b{i}", link.on_child))]
            for k, turn in enumerate(link.turned):
                if turn is not None:
                    places[k] = places[k].turned(DIRECTIONS[turn[0]], _quantity(f"angle{i}{'pc'[k]}", "rad", turn[1]))
            axes = {"U": (link.axis, link.second), "S": (), "F": (), "W": ()}.get(link.kind, (link.axis,))
            directions = (DIRECTIONS[a] if isinstance(a, str) else hd.Direction(a) for a in axes)
            joints.append(JOINTS[link.kind](f"joint{i}", *places, *directions))
        drives = tuple(
            hd.ConstantSpeed(
                f"drive{i}", f"joint{i}", _quantity(f"w{i}", "rad/s" if link.kind == "R" else "m/s", link.speed)
            )
            for i, link in enumerate(self.links)
            if link.speed is not None
        )
        gravity = (
            (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", self.gravity), DIRECTIONS[self.down]),)
            if self.gravity
            else ()
        )
        size = hd.Parameter("size", "m", 1.0)
        return hd.Scene(
            hd.Mechanism("tree", tuple(joints), tuple(pairs)),
            (*drives, *gravity, *contacts, *((hd.EnergyLedger(),) if ledger else ())),
            hd.Scales(length=size, speed=hd.Parameter("pace", "m/s", 1.0), arm=size),
        )  # fmt: skip

    @property
    def nu(self) -> int:
        return sum(link.nu for link in self.links)

    def _indices(self, counts: Sequence[int], driven: bool) -> list[int]:
        start, found = 0, []
        for link, count in zip(self.links, counts, strict=True):
            found += range(start, start + count) if (link.speed is not None) == driven else ()
            start += count
        return found

    @property
    def free(self) -> list[int]:
        return self._indices([link.nu for link in self.links], False)

    @property
    def driven(self) -> list[int]:
        return self._indices([link.nu for link in self.links], True)

    def states(self, count: int, seed: int = 0) -> Iterator[tuple[float, np.ndarray, np.ndarray, np.ndarray]]:
        """Random (t, free coordinates, free speeds, forces on all rows); quaternions have the norm 1."""
        rng = np.random.default_rng(seed)
        for _ in range(count):
            t, q = rng.uniform(0, 1), []
            for link in self.links:
                for kind, _ in link.moves if link.speed is None else ():
                    part = rng.uniform(-2, 2, 4 if kind == "S" else 1)
                    q += [*(part / np.linalg.norm(part) if kind == "S" else part)]
            yield t, np.array(q), rng.uniform(-3, 3, len(self.free)), rng.uniform(-5, 5, self.nu)

    # -- sympy.physics.mechanics -----------------------------------------------------------------------------------

    def kane(self) -> tuple[Any, Any, list[Any], dict[sp.Symbol, float]]:
        """Mass matrix and forcing by KanesMethod, its coordinates and speeds, and the numbers of its symbols."""
        t = me.dynamicsymbols._t
        q, u = me.dynamicsymbols(f"q:{sum(link.nq for link in self.links)}"), me.dynamicsymbols(f"u:{self.nu}")
        coordinates, speeds, kinematic = iter(q), iter(u), []
        ground, origin = me.ReferenceFrame("G"), me.Point("O")
        origin.set_vel(ground, 0)
        numbers: dict[sp.Symbol, float] = {}

        def symbol(name: str, value: float) -> Any:
            if value == 0:
                return sp.S.Zero
            numbers[sp.Symbol(name)] = value
            return sp.Symbol(name)

        def vector(frame: Any, name: str, values: Sequence[float]) -> Any:
            return sum(
                (symbol(f"{name}{k}", value) * along for k, (value, along) in enumerate(zip(values, frame, strict=True))), me.Vector(0),
            )  # fmt: skip

        def turned(frame: Any, name: str, turn: tuple[str, float] | None) -> Any:
            if turn is None:
                return frame
            return frame.orientnew(name, "Axis", [symbol(f"angle{name}", turn[1]), sum_of(frame, unit(turn[0]))])

        g = symbol("g", self.gravity)
        pull = {"X": ground.x, "Y": ground.y, "Z": ground.z}[self.down[1]] * (g if self.down[0] == "+" else -g)
        frames, origins, bodies, loads = [], [], [], []
        for i, link in enumerate(self.links):
            base, start = (ground, origin) if link.parent < 0 else (frames[link.parent], origins[link.parent])
            place = start.locatenew(f"J{i}", vector(base, f"a{i}", link.on_parent))
            place.v2pt_theory(start, ground, base)
            inner = turned(base, f"A{i}", link.turned[0])
            for k, (kind, axis) in enumerate(link.moves):
                outer = inner
                if kind == "P":
                    x, v = next(coordinates), next(speeds)
                    kinematic.append(x.diff(t) - v)
                    along = sum_of(inner, axis)
                    moved = place.locatenew(f"K{i}{k}", x * along)
                    moved.set_vel(ground, place.vel(ground) + v * along + (inner.ang_vel_in(ground) ^ (x * along)))
                    place = moved
                elif kind == "R":
                    x, w = next(coordinates), next(speeds)
                    kinematic.append(x.diff(t) - w)
                    inner = outer.orientnew(f"R{i}{k}", "Axis", [x, sum_of(outer, axis)])
                    inner.set_ang_vel(outer, w * sum_of(outer, axis))  # u = q' kept out of the velocities of the frame
                else:
                    e = [next(coordinates) for _ in range(4)]
                    wx, wy, wz = (next(speeds) for _ in range(3))
                    inner = outer.orientnew(f"R{i}{k}", "Quaternion", e)
                    inner.set_ang_vel(outer, wx * inner.x + wy * inner.y + wz * inner.z)
                    # Nikravesh, Computer-Aided Analysis of Mechanical Systems (1988), chapter 6: e' = L^T w/2
                    L = sp.Matrix([[-e[1], e[0], e[3], -e[2]], [-e[2], -e[3], e[0], e[1]], [-e[3], e[2], -e[1], e[0]]])
                    kinematic += list(sp.Matrix(e).diff(t) - L.T * sp.Matrix([wx, wy, wz]) / 2)
            frame = inner
            if link.turned[1] is not None:
                axis, angle = link.turned[1]
                frame = inner.orientnew(f"B{i}", "Axis", [-symbol(f"angleB{i}", angle), sum_of(inner, unit(axis))])
            elif frame is base:
                frame = inner.orientnew(f"B{i}", "Axis", [0, inner.x])
            corner = place.locatenew(f"C{i}", -vector(frame, f"b{i}", link.on_child))
            corner.v2pt_theory(place, ground, frame)
            centre = corner.locatenew(f"S{i}", vector(frame, f"s{i}", link.centre))
            centre.v2pt_theory(corner, ground, frame)
            mass = symbol(f"m{i}", link.mass)
            inertia = me.inertia(frame, *(symbol(f"J{i}{k}", v) for k, v in zip("xyz", link.inertia, strict=True)))
            bodies.append(me.RigidBody(f"body{i}", centre, frame, mass, (inertia, centre)))
            loads.append((centre, mass * pull))
            frames.append(frame)
            origins.append(corner)
        kane = me.KanesMethod(ground, q, u, kinematic)
        kane.kanes_equations(bodies, loads)
        return kane.mass_matrix, kane.forcing, [*q, *u], numbers

    @cached_property
    def _function(self) -> Any:
        mass, forcing, dynamic, numbers = self.kane()
        states = [sp.Symbol(str(x.func)) for x in dynamic]
        plain = dict(zip(dynamic, states, strict=True))
        equations = [mass.xreplace(plain), forcing.xreplace(plain)]
        return sp.lambdify([states, list(numbers)], equations, "numpy", cse=True), list(numbers.values())

    def mass_and_forcing(self, q: Sequence[float], u: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
        """Mass matrix and forcing (gravity and everything at zero accelerations) of all joints."""
        function, numbers = self._function
        mass, forcing = function([*q, *u], numbers)
        return np.array(mass, float), np.array(forcing, float).reshape(-1)

    # -- places, by hand -------------------------------------------------------------------------------------------

    def pose(self, body: int, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Origin of a body's frame and its rotation matrix at all coordinates q (complex ones too); -1 is the ground."""
        if body < 0:
            return np.zeros(3), np.eye(3)
        link = self.links[body]
        origin, turn = self.pose(link.parent, q)
        place = origin + turn @ np.array(link.on_parent)
        on_parent, on_child = link.turns()
        turn = turn @ on_parent
        values = iter(q[sum(other.nq for other in self.links[:body]) :])
        for kind, axis in link.moves:
            if kind == "P":
                place = place + next(values) * turn @ axis
            elif kind == "R":
                angle = next(values)
                turn = turn @ rodrigues(axis, np.cos(angle), np.sin(angle))
            else:
                e0, *e = (next(values) for _ in range(4))
                e1, e2, e3 = e
                tilde = np.array([[0, -e3, e2], [e3, 0, -e1], [-e2, e1, 0]])
                turn = turn @ (np.eye(3) + 2 * e0 * tilde + 2 * tilde @ tilde)
        turn = turn @ on_child.T
        return place - turn @ np.array(link.on_child), turn

    def point(self, body: int, local: Sequence[float], q: np.ndarray) -> np.ndarray:
        """Where a point fixed in a body is."""
        origin, turn = self.pose(body, q)
        return origin + turn @ np.asarray(local)

    def rates(self, q: np.ndarray) -> np.ndarray:
        """Matrix that makes rates of all coordinates of all speeds."""
        matrix, i, j = np.zeros((q.size, self.nu)), 0, 0
        for link in self.links:
            for kind, _ in link.moves:
                if kind == "S":
                    e0, e1, e2, e3 = q[i : i + 4]
                    matrix[i : i + 4, j : j + 3] = (
                        np.array([[-e1, -e2, -e3], [e0, -e3, e2], [e3, e0, -e1], [-e2, e1, e0]]) / 2
                    )
                else:
                    matrix[i, j] = 1.0
                i, j = i + (4 if kind == "S" else 1), j + (3 if kind == "S" else 1)
        return matrix

    def whole(self, t: float, values: Sequence[float], speeds: bool) -> np.ndarray:
        """States of the free joints, completed by those of the driven ones."""
        counts = [link.nu if speeds else link.nq for link in self.links]
        full = np.empty(sum(counts))
        full[self._indices(counts, False)] = values
        prescribed = [link.speed for link in self.links if link.speed is not None]
        full[self._indices(counts, True)] = [speed if speeds else speed * t for speed in prescribed]
        return full

    def accelerations(self, t: float, q: Any, u: Any, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(accelerations of the free joints, reactions of the drives) under extra generalised forces on all joints."""
        mass, forcing = self.mass_and_forcing(self.whole(t, q, False), self.whole(t, u, True))
        right, free, driven = forcing + force, self.free, self.driven
        a = np.linalg.solve(mass[np.ix_(free, free)], right[free])
        return a, mass[np.ix_(driven, free)] @ a - right[driven]


def sum_of(frame: Any, vector: np.ndarray) -> Any:
    """A vector of numbers in a frame of sympy.physics.mechanics; whole numbers exact."""
    exact = [sp.Integer(int(value)) if value == int(value) else sp.Float(value, 17) for value in vector]
    return exact[0] * frame.x + exact[1] * frame.y + exact[2] * frame.z


def random_tree(
    pattern: str, seed: int, parents: Sequence[int] | None = None, planar: int | None = None, **options: Any
) -> Tree:
    """A tree such as "R+Z P+X R-Z", its numbers drawn; `planar` is the axis (0, 1, 2) across a plane mechanism, with scalar inertias."""
    rng = np.random.default_rng(seed)
    links = []
    for i, word in enumerate(pattern.split()):
        places = [rng.uniform(-0.5, 0.5, 3).tolist() for _ in range(3)]
        for place in places if planar is not None else ():
            place[planar] = 0.0
        a, b, c = rng.uniform(0.05, 0.2, 3).tolist()
        links.append(
            Link(word[0], word[1:3], parents[i] if parents else i - 1, *(tuple(p) for p in places[:2]), rng.uniform(0.5, 2.0),
                 (a + b, b + c, c + a), tuple(places[2]), planar)
        )  # fmt: skip
    return Tree(tuple(links), **options)


def chain(n: int, axes: str) -> Tree:
    """The chain that derivations are compared on: n links along X, one behind the other, that turn about `axes` in turn; Z alone keeps it plane."""
    planar = 2 if axes == "Z" else None
    return Tree(
        tuple(
            Link("R", f"+{axes[i % len(axes)]}", i - 1, (0.5 if i else 0, 0, 0), (0, 0, 0), 1.0 + 0.1 * i, (0.1, 0.2, 0.15), (0.25, 0, 0), planar)
            for i in range(n)
        ),
        down="-Y" if planar else "-Z",
    )  # fmt: skip


def driven(tree: Tree, link: int, speed: float) -> Tree:
    """The same tree with one joint driven at constant speed."""
    return replace(tree, links=tuple(replace(l, speed=speed) if i == link else l for i, l in enumerate(tree.links)))


def link(kind, axis, parent, seed, *, second="+Y", turned=(None, None), speed=None, plane=False):
    rng = np.random.default_rng(seed)
    places = rng.uniform(-0.5, 0.5, (3, 3))
    places[:, 2] *= not plane
    a, b, c = rng.uniform(0.05, 0.2, 3).tolist()
    on_parent, on_child, centre = (tuple(place.tolist()) for place in places)
    return Link(kind, axis, parent, on_parent, on_child, rng.uniform(0.5, 2.0), (a + b, b + c, c + a), centre,
                speed=speed, second=second, turned=turned)  # fmt: skip


def line(*words, **options):
    """A chain of joints such as ("R+Z", "S", "U-X")."""
    return Tree(tuple(link(word[0], word[1:] or "+X", i - 1, i, **options) for i, word in enumerate(words)))


def rows(tree, force):
    """Generalised forces in the order of the contract: free joints, then driven ones."""
    return np.concatenate([force[tree.free], force[tree.driven]])


def deviation_of_poses(tree, derived):
    """Largest difference of the derived poses from products of rotations, at two random states [m, 1]."""
    worst = 0.0
    for t, q, _, _ in tree.states(2):
        full = tree.whole(t, q, speeds=False)
        origins, turns = zip(*(tree.pose(i, full) for i in range(len(tree.links))), strict=True)
        expected = np.ravel(origins), np.ravel(turns)
        for actual, there in zip(derived.call("poses", t=t, q=q), expected, strict=True):
            worst = max(worst, np.max(np.abs(actual - there)))
    return worst


def _quantity(name: str, unit: str, value: float) -> Any:
    return hd.Parameter(name, unit, float(value)) if value else 0


def _place(name: str, values: Sequence[float]) -> tuple[Any, ...]:
    return tuple(_quantity(f"{name}{k}", "m", float(value)) for k, value in zip("xyz", values, strict=True))


def complex_step(function: Any, q: np.ndarray) -> np.ndarray:
    """Jacobian of a function of all coordinates, to rounding: Im f(q + i h)/h, h = 1e-30."""
    columns = []
    for i in range(q.size):
        shifted = q.astype(complex)
        shifted[i] += 1e-30j
        columns.append(np.imag(function(shifted)) / 1e-30)
    return np.array(columns).T
