"""Independent oracle: a tree of bodies given to sympy.physics.mechanics (KanesMethod), and the same tree as a hertzwerk scene.

The tree is described once, in a neutral record; nothing of hertzwerk's kinematics or equations is used on the oracle's side. Driven joints
stay free there: their speed is prescribed by putting it in and their row of M a - forcing is what the drive must supply.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
import sympy.physics.mechanics as me

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    X,
    Y,
    Z,
)  # fmt: skip

DIRECTIONS = {"+X": X, "+Y": Y, "+Z": Z, "-X": -X, "-Y": -Y, "-Z": -Z}


@dataclass(frozen=True)
class Link:
    """A body on its joint: `kind` R or P, signed axis, places on parent and child, mass, principal inertias, mass centre (SI numbers)."""

    kind: str
    axis: str
    parent: int  # index of a link, -1 for the ground
    on_parent: tuple[float, ...]
    on_child: tuple[float, ...]
    mass: float
    inertia: tuple[float, float, float]
    centre: tuple[float, ...]
    scalar: int | None = None  # declare only this component of the inertia, as a scalar
    speed: float | None = None  # driven at this speed


@dataclass(frozen=True)
class Tree:
    """A mechanism, its gravity, and the two ways to its equations."""

    links: tuple[Link, ...]
    gravity: float = 9.81
    down: str = "-Y"

    # -- hertzwerk -------------------------------------------------------------------------------------------------

    @cached_property
    def bodies(self) -> list[Body]:
        bodies = []
        for i, link in enumerate(self.links):
            inertia = (
                tuple(_quantity(f"J{i}{k}", "kg m^2", value) for k, value in zip("xyz", link.inertia, strict=True))
                if link.scalar is None
                else _quantity(f"J{i}", "kg m^2", link.inertia[link.scalar])
            )
            bodies.append(Body(f"body{i}", _quantity(f"m{i}", "kg", link.mass), inertia, _place(f"s{i}", link.centre)))
        return bodies

    def scene(self, *contacts: Contact | Friction, pairs: Sequence[Any] = (), ledger: bool = True) -> Scene:
        """The scene; `pairs` and their effects may be added."""
        joints = []
        for i, link in enumerate(self.links):
            parent = GROUND if link.parent < 0 else self.bodies[link.parent]
            joint = Revolute if link.kind == "R" else Prismatic
            joints.append(
                joint(
                    f"joint{i}",
                    parent.at(*_place(f"a{i}", link.on_parent)),
                    self.bodies[i].at(*_place(f"b{i}", link.on_child)),
                    DIRECTIONS[link.axis],
                )
            )
        drives = tuple(
            ConstantSpeed(
                f"drive{i}", f"joint{i}", _quantity(f"w{i}", "rad/s" if link.kind == "R" else "m/s", link.speed)
            )
            for i, link in enumerate(self.links)
            if link.speed is not None
        )
        gravity = (
            (Gravity("gravity", Parameter("g", "m/s^2", self.gravity), DIRECTIONS[self.down]),) if self.gravity else ()
        )
        size = Parameter("size", "m", 1.0)
        return Scene(
            Mechanism("tree", tuple(joints), tuple(pairs)),
            (*drives, *gravity, *contacts, *((EnergyLedger(),) if ledger else ())),
            Scales(length=size, speed=Parameter("pace", "m/s", 1.0), arm=size),
        )  # fmt: skip

    @property
    def free(self) -> list[int]:
        return [i for i, link in enumerate(self.links) if link.speed is None]

    @property
    def driven(self) -> list[int]:
        return [i for i, link in enumerate(self.links) if link.speed is not None]

    # -- sympy.physics.mechanics -----------------------------------------------------------------------------------

    @cached_property
    def _kane(self) -> Any:
        n = len(self.links)
        t = me.dynamicsymbols._t
        q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
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
                (
                    symbol(f"{name}{k}", value) * along
                    for k, (value, along) in enumerate(zip(values, frame, strict=True))
                ),
                me.Vector(0),
            )

        g = symbol("g", self.gravity)
        pull = {"X": ground.x, "Y": ground.y, "Z": ground.z}[self.down[1]] * (g if self.down[0] == "+" else -g)
        frames, origins, bodies, loads = [], [], [], []
        for i, link in enumerate(self.links):
            base, start = (ground, origin) if link.parent < 0 else (frames[link.parent], origins[link.parent])
            axis = {"X": base.x, "Y": base.y, "Z": base.z}[link.axis[1]] * (1 if link.axis[0] == "+" else -1)
            frame = base.orientnew(f"B{i}", "Axis", [q[i] if link.kind == "R" else 0, axis])
            if link.kind == "R":  # u = q' kept out of the velocities of the frame
                frame.set_ang_vel(base, u[i] * axis)
            place = start.locatenew(f"J{i}", vector(base, f"a{i}", link.on_parent))
            place.v2pt_theory(start, ground, base)
            if link.kind == "P":
                moved = place.locatenew(f"K{i}", q[i] * axis)
                moved.set_vel(ground, place.vel(ground) + u[i] * axis + (base.ang_vel_in(ground) ^ (q[i] * axis)))
                place = moved
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
        kane = me.KanesMethod(ground, q, u, [a.diff(t) - b for a, b in zip(q, u, strict=True)])
        kane.kanes_equations(bodies, loads)
        states = [sp.Symbol(str(x.func)) for x in (*q, *u)]
        plain = dict(zip((*q, *u), states, strict=True))
        function = sp.lambdify(
            [states, list(numbers)],
            [kane.mass_matrix.xreplace(plain), kane.forcing.xreplace(plain)],
            "numpy",
            cse=True,
        )
        return function, list(numbers.values())

    def mass_and_forcing(self, q: Sequence[float], u: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
        """Mass matrix and forcing (gravity and everything at zero accelerations) of all joints."""
        function, numbers = self._kane
        mass, forcing = function([*q, *u], numbers)
        return np.array(mass, float), np.array(forcing, float).reshape(-1)

    # -- places, by hand -------------------------------------------------------------------------------------------

    def pose(self, body: int, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Origin of a body's frame and its rotation matrix at all coordinates q (complex ones too); -1 is the ground."""
        if body < 0:
            return np.zeros(3), np.eye(3)
        link = self.links[body]
        origin, base = self.pose(link.parent, q)
        k, sign = "XYZ".index(link.axis[1]), 1 if link.axis[0] == "+" else -1
        place = origin + base @ np.array(link.on_parent)
        turn = base
        if link.kind == "R":
            c, s = np.cos(q[body]), sign * np.sin(q[body])
            i, j = (k + 1) % 3, (k + 2) % 3
            rotation = np.eye(3, dtype=q.dtype)
            rotation[i, i] = rotation[j, j] = c
            rotation[j, i], rotation[i, j] = s, -s
            turn = base @ rotation
        else:
            place = place + sign * q[body] * base[:, k]
        return place - turn @ np.array(link.on_child), turn

    def point(self, body: int, local: Sequence[float], q: np.ndarray) -> np.ndarray:
        """Where a point fixed in a body is."""
        origin, turn = self.pose(body, q)
        return origin + turn @ np.asarray(local)

    def whole(self, t: float, values: Sequence[float], speeds: bool) -> np.ndarray:
        """States of the free joints, completed by those of the driven ones."""
        full = np.empty(len(self.links))
        full[self.free] = values
        for i in self.driven:
            full[i] = self.links[i].speed if speeds else self.links[i].speed * t
        return full

    def accelerations(self, t: float, q: Any, u: Any, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(accelerations of the free joints, reactions of the drives) under extra generalised forces on all joints."""
        mass, forcing = self.mass_and_forcing(self.whole(t, q, False), self.whole(t, u, True))
        right, free, driven = forcing + force, self.free, self.driven
        a = np.linalg.solve(mass[np.ix_(free, free)], right[free])
        return a, mass[np.ix_(driven, free)] @ a - right[driven]


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


def driven(tree: Tree, link: int, speed: float) -> Tree:
    """The same tree with one joint driven at constant speed."""
    return replace(tree, links=tuple(replace(l, speed=speed) if i == link else l for i, l in enumerate(tree.links)))


def _quantity(name: str, unit: str, value: float) -> Any:
    return Parameter(name, unit, float(value)) if value else 0


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
