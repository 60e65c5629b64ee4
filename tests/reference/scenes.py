"""Scenes of many contact pairs: a row of equal spheres, and a slider-crank with guards that nothing reaches."""

import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Material,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    SphereOnSphere,
    Start,
    X,
    Y,
)
from hertzwerk.derive.laws import flores, hertz_point
from hertzwerk.derive.scenes import slider_crank


def row(n: int) -> Scene:
    """n equal spheres on a line, a gap between neighbours; the first comes in with 1 m/s, the others are at rest."""
    m, R, gap = Parameter("mass", "kg", 0.1), Parameter("radius", "m", 0.02), Parameter("gap", "mm", 1)
    v, e = Parameter("speed", "m/s", 1), Parameter("restitution", "1", 1)
    steel = Material(Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3))
    balls = [Body(f"ball_{i}", mass=m) for i in range(n)]
    joints = tuple(Prismatic(f"path_{i}", GROUND, ball, axis=X) for i, ball in enumerate(balls))
    pairs = tuple(
        SphereOnSphere(f"pair_{i}", balls[i].at(0, 0, 0), balls[i + 1].at(0, 0, 0), R, R) for i in range(n - 1)
    )
    return Scene(
        Mechanism(f"row_{n}", joints, pairs),
        effects=(*(Contact(pair.name, hertz_point(steel, steel), flores(e)) for pair in pairs), EnergyLedger()),
        start=Start(position={f"path_{i}": i * (2 * R + gap) for i in range(1, n)}, speed={"path_0": v}),
        scales=Scales(length=Parameter("length_scale", "um", 20), speed=v),
        summary=f"a row of {n} spheres",
    )


def guarded_crank(guards: int) -> Scene:
    """The slider-crank with clearance, frictionless, and up to 9 spheres on its bodies, before planes that they never reach."""
    scene = slider_crank.scene.without("slider_pin_friction")
    joints = {joint.name: joint for joint in scene.mechanism.joints}
    crank, rod, slider = (joints[name].child.body for name in ("main_bearing", "crank_pin", "guide"))
    r, l = slider_crank.r, slider_crank.l
    radius, away = Parameter("guard_radius", "mm", 5), Parameter("guard_distance", "m", 0.25)
    places = [
        *((rod.at(l / 2, 0, 0), normal) for normal in (Y, -Y)),
        (slider.at(0, 0, 0), -X),  # the crank's own last: their gaps are moved by the drive alone, which takes a state
        *((crank.at(part * r, 0, 0), normal) for part in (1, sp.Rational(1, 2)) for normal in (X, Y, -Y)),
    ]
    planes = {X: (-away, 0, 0), -X: (away, 0, 0), Y: (0, -away, 0), -Y: (0, away, 0)}
    pairs = tuple(
        SphereOnPlane(f"guard_{i}", point, radius, plane=GROUND.at(*planes[normal]), normal=normal)
        for i, (point, normal) in enumerate(places[:guards])
    )
    contact = scene.effect("slider_pin")
    return Scene(
        Mechanism(f"guarded_crank_{guards}", scene.mechanism.joints, (*scene.mechanism.pairs, *pairs)),
        effects=(*scene.effects, *(Contact(pair.name, contact.stiffness, contact.damping) for pair in pairs)),
        start=scene.start,
        scales=scene.scales,
        summary=f"slider-crank with a clearance joint and {guards} guards",
    )
