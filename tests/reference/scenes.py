"""Scenes of many contact pairs: spheres in a row, in a plane and in a box, and a slider-crank with guards that nothing reaches."""

from dataclasses import dataclass

import numpy as np
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, hertz_point, hunt_crossley, power, power_damping
from hertzwerk.derive.scenes import slider_crank
from hertzwerk.derive.scenes import spheres_in_box as box


def row(n: int) -> hd.Scene:
    """n equal spheres on a line, a gap between neighbours; the first comes in with 1 m/s, the others are at rest."""
    m, R, gap = hd.Parameter("mass", "kg", 0.1), hd.Parameter("radius", "m", 0.02), hd.Parameter("gap", "mm", 1)
    v, e = hd.Parameter("speed", "m/s", 1), hd.Parameter("restitution", "1", 1)
    steel = hd.Material(hd.Parameter("youngs_modulus", "GPa", 207), hd.Parameter("poissons_ratio", "1", 0.3))
    balls = [hd.Body(f"ball_{i}", mass=m) for i in range(n)]
    joints = tuple(hd.Prismatic(f"path_{i}", hd.GROUND, ball, axis=hd.X) for i, ball in enumerate(balls))
    pairs = tuple(
        hd.SphereOnSphere(f"pair_{i}", balls[i].at(0, 0, 0), balls[i + 1].at(0, 0, 0), R, R) for i in range(n - 1)
    )
    return hd.Scene(
        hd.Mechanism(f"row_{n}", joints, pairs),
        effects=(*(hd.Contact(pair.name, hertz_point(steel, steel), flores(e)) for pair in pairs), hd.EnergyLedger()),
        start=hd.Start(position={f"path_{i}": i * (2 * R + gap) for i in range(1, n)}, speed={"path_0": v}),
        scales=hd.Scales(length=hd.Parameter("length_scale", "um", 20), speed=v),
        summary=f"a row of {n} spheres",
    )


def balls(n: int) -> hd.Scene:
    """n equal balls in a plane, each pair of which may touch, and the floor; every second one comes in from the other side."""
    m, J, R = hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1e-3), hd.Parameter("radius", "m", 0.05)
    K, e = hd.Parameter("stiffness", "N/m^1.5", 1e7), hd.Parameter("restitution", "1", 0.8)
    bodies = [hd.Body(f"ball_{i}", m, J) for i in range(n)]
    joints = tuple(hd.Planar(f"free_{i}", hd.GROUND, body) for i, body in enumerate(bodies))
    centres = [body.at(0, 0, 0) for body in bodies]
    pairs = (
        *hd.every_pair("pair", centres, R),
        *(hd.SphereOnPlane(f"floor_{i}", centre, R, plane=hd.GROUND.at(0, 0, 0), normal=hd.Y) for i, centre in enumerate(centres)),
    )  # fmt: skip
    position = {
        f"free_{i}.{axis}": hd.Parameter(f"{axis}_{i}", "m", x)
        for i in range(n)
        for axis, x in (("x", 0.12 * i), ("y", 0.06 + 0.01 * i))
    }
    speed = {f"free_{i}.x": hd.Parameter(f"v_{i}", "m/s", (-1) ** i * (1 + 0.1 * i)) for i in range(n)}
    return hd.Scene(
        hd.Mechanism(f"balls_{n}", joints, pairs),
        effects=(
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y),
            *(hd.Contact(pair.name, power(K, n=1.5), flores(e)) for pair in pairs),
            hd.EnergyLedger(),
        ),
        start=hd.Start(position=position, speed=speed),
        scales=hd.Scales(length=R, arm=R, speed=hd.Parameter("pace", "m/s", 1)),
        summary=f"{n} balls on a floor",
    )


def spheres_in_box(n: int, across: int = 2) -> hd.Scene:
    """The spheres of the gallery with damping that keeps the approach speed of each contact."""
    return box.spheres_in_box(n, across, damping=hunt_crossley(hd.Parameter("restitution", "1", 0.3)))


@dataclass(frozen=True)
class Ball:
    """Numbers in SI of a ball that falls onto a plane: force K d (1 + loss d') of plane and other balls."""

    mass: float = 1.0
    radius: float = 0.05
    stiffness: float = 1e5
    loss: float = 0.2
    gravity: float = 9.81

    @staticmethod
    def place(i: int) -> tuple[float, float, float]:
        """Return where ball i starts: beside the others, with a height of its own."""
        return 0.12 * (i % 10), 0.12 * (i // 10), 0.1 + 0.003 * i + 0.01 * (i % 4)


FALLING = Ball()


def falling_balls(n: int) -> hd.Scene:
    """n balls in space that fall beside one another onto a plane; each pair of them may touch."""
    radius, stiffness = hd.Parameter("radius", "m", FALLING.radius), hd.Parameter("stiffness", "N/m", FALLING.stiffness)
    density = hd.Parameter("density", "kg/m^3", FALLING.mass / (4 / 3 * np.pi * FALLING.radius**3))
    law = power(stiffness, n=1), power_damping(hd.Parameter("loss", "s/m", FALLING.loss) * stiffness, 1)
    balls = [hd.Body.sphere(f"ball_{i}", radius, density=density) for i in range(n)]
    ground = hd.GROUND.at(0, 0, 0)
    floors = [
        hd.SphereOnPlane(f"floor_{i}", ball.at(0, 0, 0), radius, ground, normal=hd.Z) for i, ball in enumerate(balls)
    ]
    starts = {
        f"flight_{i}.{axis}": hd.Parameter(f"{axis}_{i}", "m", x)
        for i in range(n)
        for axis, x in zip("xyz", FALLING.place(i), strict=True)
    }
    return hd.Scene(
        hd.Mechanism(
            f"falling_balls_{n}",
            tuple(hd.Free(f"flight_{i}", hd.GROUND, ball) for i, ball in enumerate(balls)),
            (*hd.every_pair("balls", balls, radius), *floors),
        ),
        effects=(
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", FALLING.gravity), direction=-hd.Z),
            hd.Contact("balls", *law),
            *(hd.Contact(floor.name, *law) for floor in floors),
        ),
        start=hd.Start(position=starts),
        scales=hd.Scales(length=radius / 10, arm=radius, speed=hd.Parameter("pace", "m/s", 1)),
        summary=f"{n} balls fall onto a plane",
    )


def guarded_crank(guards: int) -> hd.Scene:
    """The slider-crank with clearance, frictionless, and up to 99 spheres on its bodies, before planes that they never reach."""
    scene = slider_crank.scene.without("slider_pin_friction")
    joints = {joint.name: joint for joint in scene.mechanism.joints}
    crank, rod, slider = (joints[name].child.body for name in ("main_bearing", "crank_pin", "guide"))
    r, l = slider_crank.r, slider_crank.l
    radius, away = hd.Parameter("guard_radius", "mm", 5), hd.Parameter("guard_distance", "m", 0.25)
    places = [
        *((rod.at(l / 2, 0, 0), normal) for normal in (hd.Y, -hd.Y)),
        (
            slider.at(0, 0, 0),
            -hd.X,
        ),  # the crank's own last: their gaps are moved by the drive alone, which takes a state
        *((crank.at(part * r, 0, 0), normal) for part in (1, sp.Rational(1, 2)) for normal in (hd.X, hd.Y, -hd.Y)),
        *((rod.at(sp.Rational(k, 46) * l, 0, 0), normal) for k in range(1, 46) for normal in (hd.Y, -hd.Y)),
    ]
    planes = {hd.X: (-away, 0, 0), -hd.X: (away, 0, 0), hd.Y: (0, -away, 0), -hd.Y: (0, away, 0)}
    pairs = tuple(
        hd.SphereOnPlane(f"guard_{i}", point, radius, plane=hd.GROUND.at(*planes[normal]), normal=normal)
        for i, (point, normal) in enumerate(places[:guards])
    )
    contact = scene.effect("slider_pin")
    return hd.Scene(
        hd.Mechanism(f"guarded_crank_{guards}", scene.mechanism.joints, (*scene.mechanism.pairs, *pairs)),
        effects=(*scene.effects, *(hd.Contact(pair.name, contact.stiffness, contact.damping) for pair in pairs)), start=scene.start,
        scales=scene.scales, summary=f"slider-crank with a clearance joint and {guards} guards",
    )  # fmt: skip
