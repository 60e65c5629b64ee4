"""Scenes of the hard cases that are no built-in scenes; derived when run, never committed.

Free impacts (see `impact.impact_scene`), grazing contact, a tugged ball, a ball on a vibrating table, rows of spheres, bodies of very
different mass, a block on an incline, a falling chain, a rocking block, a relay that chatters, a track of arcs and
lines, boxes corner over corner, a table on four feet, a ball that rolls over another, a sleigh at rest; and those of the files beside.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import sympy as sp

from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.controllers import Relay
from hertzwerk.derive.declare.effects.drives import ConstantSpeed, Harmonic
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.forces import JointForce
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.nonholonomic import KnifeEdge, RollingWithoutSlip
from hertzwerk.derive.declare.effects.springs import JointDamper
from hertzwerk.derive.declare.effects.state_expression import T, speed_of
from hertzwerk.derive.declare.effects.tribology.joint_friction import JointFriction
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, X, Y, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic, Revolute
from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.declare.mechanism.joints.free import Free
from hertzwerk.derive.declare.mechanism.joints.planar import Planar
from hertzwerk.derive.declare.mechanism.joints.track import PointInTrack
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.mechanism.outline import Arc, Line, Outline
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.box_on_box import BoxOnBox
from hertzwerk.derive.equations.contact.pairs.box_on_plane import BoxOnPlane
from hertzwerk.derive.equations.contact.pairs.curves_and_gears import CurveOnCurve
from hertzwerk.derive.equations.contact.pairs.on_plane import SphereOnPlane
from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import SphereOnSphere
from hertzwerk.derive.exchange.law_sheets.free_impact import impact_scene
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import (
    coulomb,
    exact,
    flores,
    hunt_crossley,
    kelvin_voigt,
    lugre,
    power,
    power_damping,
    ristow,
    smooth_coulomb,
)
from hertzwerk.derive.laws.law import BoundLaw, DampingLaw
from hertzwerk.derive.scenes.hard.cone_and_resistances import AT_LIMITS
from hertzwerk.derive.scenes.hard.coupled_shafts import COUPLED
from hertzwerk.derive.scenes.hard.slips_at_lift_off import LATE_SLIPS
from hertzwerk.derive.scenes.hard.worn_joint_and_pad import WORN

_MASS = Parameter("mass", "kg", 1)
_RADIUS = Parameter("radius", "m", 0.02)
_SPEED = Parameter("speed", "m/s", 1, "at the start")
_EXPONENT = Parameter("exponent", "1", 1.5, "n of K d^n")
_STIFFNESS = Parameter("stiffness", "N/m^exponent", 1e8, "K of K d^n")
_RESTITUTION = Parameter("restitution", "1", 1)

_FRICTION = Parameter("friction_coefficient", "1", 0.5)
_STATIC = Parameter("static_coefficient", "1", 0.5)

FORCE_RELEASED = replace(kelvin_voigt, name="kelvin_voigt_without_pull", release="force")
"""Kelvin and Voigt's law whose contact ends where its force falls to zero, before it would pull."""


def free_impact(law: DampingLaw) -> Scene:
    """One impact of a free ball, from gap 0, with its energy ledger."""
    scene = impact_scene(law)
    return replace(scene, effects=(*scene.effects, EnergyLedger()), name=f"free_impact_{law.name}")


def grazing_ball() -> Scene:
    """A ball that approaches a floor and is pulled away from it, reversing at a chosen gap.

    The gap is the coordinate itself.
    """
    pull = Parameter("pull", "m/s^2", 8, "acceleration away from the floor")
    ball = Body("ball", mass=_MASS)
    depth = ((_EXPONENT + 1) * _MASS * _SPEED**2 / (2 * _STIFFNESS)) ** (1 / (_EXPONENT + 1))
    floor = SphereOnPlane("floor", ball.at(0, 0, 0), _RADIUS, plane=GROUND.at(0, -_RADIUS, 0), normal=Y)
    return Scene(
        Mechanism("grazing_ball", joints=(Prismatic("ball", GROUND, ball, axis=Y),), pairs=(floor,)),
        effects=(
            Gravity("pull_away", pull, direction=Y),
            Contact("floor", power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)),
            EnergyLedger(),
        ),
        start=Start(position={"ball": _SPEED**2 / (2 * pull)}, speed={"ball": -_SPEED}),
        scales=Scales(length=depth, speed=_SPEED),
        summary="a ball that comes near the floor",
    )


def tugged_ball() -> Scene:
    """A ball pressed in, which a force pulls out faster than its law follows, for a moment.

    While it touches, the force moves it to -0.1 + 0.02 t^2 - 0.04/3 t^3 [m], at up to 0.01 m/s.
    """
    unit, second = Parameter("unit", "m", 1), Parameter("second", "s", 1)
    stiffness, fastest = (
        Parameter("stiffness", "N/m", 0.01),
        Parameter("fastest", "m/s", 0.009991, "from which on it pulls"),
    )
    time, body = T / second, Body("ball", mass=_MASS)
    place = unit * (-0.1 + 0.02 * time**2 - 0.04 / 3 * time**3)
    speed, acceleration = unit / second * 0.04 * (time - time**2), unit / second**2 * 0.04 * (1 - 2 * time)
    floor = SphereOnPlane("floor", body.at(0, 0, 0), unit, plane=GROUND.at(0, 0, 0), normal=Y)
    return Scene(
        Mechanism("tugged_ball", joints=(Prismatic("ball", GROUND, body, axis=Y),), pairs=(floor,)),
        effects=(
            Contact("floor", power(stiffness, 1), power_damping(stiffness / fastest, 1)),
            JointForce("tug", "ball", _MASS * acceleration + stiffness * place * (1 - speed / fastest)),
            EnergyLedger(),
        ),
        start=Start(position={"ball": 0.9 * unit}),
        scales=Scales(length=0.1 * unit, speed=10 * fastest),
        summary="a ball that is pulled out of the ground for a moment",
    )


def shaken_ball() -> Scene:
    """A ball on a vibrating table, at whose lowest place it starts, resting on it.

    The table moves as amplitude sin(frequency t + phase).
    """
    amplitude, phase = Parameter("amplitude", "m", 4e-4), Parameter("phase", "rad", 1.5 * math.pi)
    frequency = Parameter("frequency", "rad/s", 40 * math.pi)
    stiffness = Parameter("stiffness", "N/m", 1e8)
    table, ball = Body("table", mass=_MASS), Body("ball", mass=_MASS)
    floor = SphereOnPlane("floor", ball.at(0, 0, 0), _RADIUS, plane=table.at(0, 0, 0), normal=Y)
    joints = (Prismatic("table", GROUND, table, axis=Y), Prismatic("ball", GROUND, ball, axis=Y))
    return Scene(
        Mechanism("shaken_ball", joints=joints, pairs=(floor,)),
        effects=(
            Harmonic("shaker", "table", amplitude, frequency, phase),
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            Contact("floor", power(stiffness, 1), exact(_RESTITUTION)),
            EnergyLedger(),
        ),
        start=Start(
            position={"ball": _RADIUS + amplitude * sp.sin(phase)},
            speed={"ball": amplitude * frequency * sp.cos(phase)},
        ),
        scales=Scales(length=amplitude, speed=amplitude * frequency),
        summary="a ball on a vibrating table",
    )


def row_of_spheres(count: int) -> Scene:
    """Equal spheres on one line, `gap` apart; the first moves towards the others."""
    gap = Parameter("gap", "m", 0.001, "between neighbours at the start")
    spheres = [Body(f"sphere_{i}", mass=_MASS) for i in range(1, count + 1)]
    joints = [Prismatic(f"path_{i}", GROUND, sphere, axis=X) for i, sphere in enumerate(spheres, 1)]
    pairs = [
        SphereOnSphere(f"pair_{i}", left.at(0, 0, 0), right.at(0, 0, 0), _RADIUS, _RADIUS)
        for i, (left, right) in enumerate(pairwise(spheres), 1)
    ]
    law = power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)
    return Scene(
        Mechanism(f"row_of_{count}", joints=tuple(joints), pairs=tuple(pairs)),
        effects=(*(Contact(pair.name, *law) for pair in pairs), EnergyLedger()),
        start=Start(
            position={f"path_{i}": (i - 1) * (2 * _RADIUS + gap) for i in range(2, count + 1)},
            speed={"path_1": _SPEED},
        ),
        scales=Scales(length=_depth(_MASS / 2), speed=_SPEED),
        summary=f"a sphere meets a row of {count - 1}",
    )


def touching_row(count: int) -> Scene:
    """Equal spheres in contact, optionally compressed from both ends, struck at either end.

    Each coordinate is zero where its sphere touches the next, so that coordinates are small, while a gap is a small
    difference of large lengths.
    """
    preload = Parameter("preload", "N", 0, "that presses the row together from both ends")
    last_speed = Parameter("last_speed", "m/s", 0, "of the last sphere at the start")
    spheres = [Body(f"sphere_{i}", mass=_MASS) for i in range(1, count + 1)]
    joints = [
        Prismatic(f"path_{i}", GROUND.at(2 * (i - 1) * _RADIUS, 0, 0), sphere, axis=X)
        for i, sphere in enumerate(spheres, 1)
    ]
    pairs = [
        SphereOnSphere(f"pair_{i}", left.at(0, 0, 0), right.at(0, 0, 0), _RADIUS, _RADIUS)
        for i, (left, right) in enumerate(pairwise(spheres), 1)
    ]
    law = power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)
    depth = (preload / _STIFFNESS) ** (1 / _EXPONENT)
    return Scene(
        Mechanism(f"touching_row_of_{count}", joints=tuple(joints), pairs=tuple(pairs)),
        effects=(
            *(Contact(pair.name, *law) for pair in pairs),
            JointForce("push_first", "path_1", preload),
            JointForce("push_last", f"path_{count}", -preload),
            EnergyLedger(),
        ),
        start=Start(
            position={f"path_{i}": -(i - 1) * depth for i in range(2, count + 1)},
            speed={"path_1": _SPEED, f"path_{count}": last_speed},
        ),
        scales=Scales(length=_depth(_MASS / 2), speed=_SPEED),
        summary=f"a row of {count} spheres that touch, struck at its ends",
    )


def struck_from_both_sides() -> Scene:
    """A sphere at rest, struck at the same instant from both sides."""
    gap = Parameter("gap", "m", 0.001, "to either side of the sphere in the middle")
    left, middle, right = (Body(name, mass=_MASS) for name in ("left", "middle", "right"))
    law = power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)
    return Scene(
        Mechanism(
            "struck_from_both_sides",
            joints=tuple(Prismatic(body.name, GROUND, body, axis=X) for body in (left, middle, right)),
            pairs=(
                SphereOnSphere("left_pair", left.at(0, 0, 0), middle.at(0, 0, 0), _RADIUS, _RADIUS),
                SphereOnSphere("right_pair", middle.at(0, 0, 0), right.at(0, 0, 0), _RADIUS, _RADIUS),
            ),
        ),
        effects=(Contact("left_pair", *law), Contact("right_pair", *law), EnergyLedger()),
        start=Start(
            position={"left": -2 * _RADIUS - gap, "right": 2 * _RADIUS + gap},
            speed={"left": _SPEED, "right": -_SPEED},
        ),
        scales=Scales(length=_depth(_MASS), speed=_SPEED),
        summary="a sphere struck from both sides at once",
    )


def unlike_masses() -> Scene:
    """Impact on a sphere of very different mass at rest; the restitution is returned exactly."""
    striker, target = (
        Body(name, mass=Parameter(f"{name}_mass", "kg", 1, "of equal radius")) for name in ("striker", "target")
    )
    gap = Parameter("gap", "m", 0.001, "between the spheres at the start")
    reduced = striker.mass * target.mass / (striker.mass + target.mass)
    return Scene(
        Mechanism(
            "unlike_masses",
            joints=tuple(Prismatic(f"{body.name}_path", GROUND, body, axis=X) for body in (striker, target)),
            pairs=(SphereOnSphere("spheres", striker.at(0, 0, 0), target.at(0, 0, 0), _RADIUS, _RADIUS),),
        ),
        effects=(Contact("spheres", power(_STIFFNESS, _EXPONENT), exact(_RESTITUTION)), EnergyLedger()),
        start=Start(position={"target_path": 2 * _RADIUS + gap}, speed={"striker_path": _SPEED}),
        scales=Scales(length=_depth(reduced), speed=_SPEED),
        summary="a sphere meets one of another mass at rest",
    )


def incline(friction: BoundLaw) -> Scene:
    """A block on an incline of 3 in 4, in the incline's axes, at its static penetration.

    It may slide downhill or stick. A light carriage moves with it, without friction of its own.
    """
    gravity = Parameter("gravity", "m/s^2", 9.81)
    carriage = Body("carriage", mass=_MASS / 1000)
    block = Body("block", mass=_MASS)
    normal_load = sp.Rational(4, 5) * gravity * _MASS
    depth = (normal_load / _STIFFNESS) ** (1 / _EXPONENT)
    return Scene(
        Mechanism(
            "incline",
            joints=(Prismatic("downhill", GROUND, carriage, axis=X), Prismatic("normal", carriage, block, axis=Y)),
            pairs=(SphereOnPlane("surface", block.at(0, 0, 0), _RADIUS, plane=GROUND.at(0, -_RADIUS, 0), normal=Y),),
        ),
        effects=(
            Gravity("gravity", gravity, direction=Direction((sp.Rational(3, 5), sp.Rational(-4, 5), 0))),
            Contact("surface", power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)),
            Friction("friction", "surface", friction),
            EnergyLedger(),
        ),
        start=Start(position={"normal": -depth}, speed={"downhill": _SPEED}),
        scales=Scales(length=depth, speed=_SPEED),
        name=f"incline_{friction.law.name}",
        summary=f"a block on an incline, {friction.law.title}",
    )


def falling_chain(count: int) -> Scene:
    """Links with set-valued friction at every joint and end that fall on a floor and come to rest.

    They come to rest nearly in line.
    """
    mass, length, bend = Parameter("mass", "kg", 0.1), Parameter("link_length", "m", 0.1), Parameter("bend", "rad", 0.1)
    inertia, height = (
        Parameter("inertia", "kg m^2", 8e-5),
        Parameter("height", "m", 0.1, "of the first end at the start"),
    )
    radius, tilt = (
        Parameter("corner_radius", "m", 0.01),
        Parameter("tilt", "rad", 0.1, "of the first link at the start"),
    )
    links = [Body(f"link_{i}", mass=mass, inertia=inertia, centre=(length / 2, 0, 0)) for i in range(1, count + 1)]
    joints = [
        Planar("path", GROUND, links[0], normal=Z),
        *(Revolute(f"pin_{i}", a.at(length, 0, 0), b, axis=Z) for i, (a, b) in enumerate(pairwise(links), 1)),
    ]
    ends = [links[0].at(0, 0, 0), *(link.at(length, 0, 0) for link in links)]
    pairs = [
        SphereOnPlane(f"corner_{i}", end, radius, plane=GROUND.at(0, 0, 0), normal=Y) for i, end in enumerate(ends)
    ]
    law = power(_STIFFNESS, _EXPONENT), flores(_RESTITUTION)
    return Scene(
        Mechanism(f"falling_chain_of_{count}", joints=tuple(joints), pairs=tuple(pairs)),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            *(Contact(pair.name, *law) for pair in pairs),
            *(Friction(f"{pair.name}_friction", pair.name, coulomb(_FRICTION, _STATIC)) for pair in pairs),
            EnergyLedger(),
        ),
        start=Start(
            position={"path.y": height, "path.angle": tilt, **{f"pin_{i}": (-1) ** i * bend for i in range(1, count)}}
        ),
        scales=Scales(length=Parameter("depth", "mm", 1), speed=Parameter("speed", "m/s", 1), arm=length),
        summary=f"a chain of {count} links falls on a floor, with dry friction at {count + 1} corners",
    )


def chattering_relay() -> Scene:
    """A sled whose speed a relay without hysteresis keeps at zero, against a drag."""
    relay = Relay("relay", speed_of("slide"), unit="m/s")
    return Scene(
        Mechanism("chattering_relay", joints=(Prismatic("slide", GROUND, Body("sled", mass=_MASS), axis=X),)),
        effects=(
            relay,
            JointForce("jets", "slide", Parameter("thrust", "N", 3) * relay.output),
            JointDamper("drag", "slide", Parameter("drag", "N s/m", 10)),
            EnergyLedger(),
        ),
        scales=Scales(length=Parameter("size", "m", 0.1), speed=_SPEED),
        summary="a sled at rest by a relay that chatters",
    )


def jamming_guide() -> Scene:
    """A block that slides on two pads, with its mass centre above them, which friction presses."""
    block = Body(
        "block", mass=_MASS, inertia=Parameter("inertia", "kg m^2", 0.01), centre=(0, Parameter("arm", "m", 0.2), 0)
    )
    rubs = smooth_coulomb(_FRICTION, _LAYER)
    return Scene(
        Mechanism("jamming_guide", joints=(Prismatic("slide", GROUND, block, axis=X),)),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            JointFriction("friction", "slide", rubs, length=Parameter("length", "m", 0.1)),
            EnergyLedger(),
        ),
        start=Start(speed={"slide": _SPEED}),
        scales=Scales(length=Parameter("size", "m", 0.1), speed=_SPEED),
        summary="a block that brakes on a guide, which locks where mu reaches length/(2 arm)",
    )


def rocking_block() -> Scene:
    """A slender block let go from a tilt, at rest on one corner, until its other corner strikes."""
    width, height = Parameter("width", "m", 0.1), Parameter("height", "m", 0.6)
    mass, gravity, tilt = (
        Parameter("mass", "kg", 7),
        Parameter("gravity", "m/s^2", 9.81),
        Parameter("tilt", "rad", 0.08),
    )
    block = Body("block", mass, mass * (width**2 + height**2) / 12)
    stiffness = Parameter("stiffness", "N/m", 1e9)
    up = width / 2 * sp.sin(tilt) + height / 2 * sp.cos(tilt) - mass * gravity / stiffness
    across = width / 2 * (1 - sp.cos(tilt)) - height / 2 * sp.sin(tilt)
    floor = BoxOnPlane("floor", block.at(0, 0, 0), width, height, GROUND.at(0, 0, 0), Y)
    return Scene(
        Mechanism("rocking_block", joints=(Planar("move", GROUND, block, normal=Z),), pairs=(floor,)),
        effects=(
            Gravity("gravity", gravity, direction=-Y),
            Contact("floor", power(stiffness, 1), flores(_RESTITUTION)),
            Friction("friction", "floor", coulomb(_FRICTION, _STATIC)),
            EnergyLedger(),
        ),
        start=Start(position={"move.x": across, "move.y": up, "move.angle": -tilt}),
        scales=Scales(length=Parameter("size", "mm", 1), speed=Parameter("pace", "m/s", 0.1), arm=width),
        summary="a block that rocks from corner to corner",
    )


def track_round() -> Scene:
    """A bead in a track of two half circles and two lines, at whose junctions its force jumps."""
    straight, radius, pace = (
        Parameter("straight", "m", 0.04),
        Parameter("radius", "m", 0.015),
        Parameter("pace", "m/s", 2),
    )
    arcs = Arc((straight, radius), (straight, 0)), Arc((0, -radius), (0, 0))
    stadium = Outline("stadium", (0, -radius), [Line((straight, -radius)), arcs[0], Line((0, radius)), arcs[1]])
    bead = Body("bead", _MASS, Parameter("inertia", "kg m^2", 1e-4))
    return Scene(
        Mechanism("track_round", (Planar("plane", GROUND, bead), PointInTrack("track", GROUND, bead, stadium))),
        effects=(EnergyLedger(),),
        start=Start(position={"plane.x": straight / 2}, near={"plane.y": -radius}, speed={"plane.x": pace}),
        scales=Scales(length=radius, speed=pace, arm=radius),
        summary="a bead in a track of half circles and lines",
    )


def aligned_boxes() -> Scene:
    """A rectangle dropped on an equal one, corner over corner to within rounding, on the floor."""
    size, radius, stiffness = (
        Parameter("size", "m", 0.1),
        Parameter("radius", "mm", 1),
        Parameter("stiffness", "N/m", 1e6),
    )
    drop, aside = Parameter("drop", "mm", 1), Parameter("aside", "m", 1e-15)
    low, high = (Body(name, _MASS, _MASS * size**2 / 6) for name in ("low", "high"))
    pairs = (
        BoxOnPlane("floor", low.at(0, 0, 0), size, size, GROUND.at(0, 0, 0), Y),
        BoxOnBox("stack", high.at(0, 0, 0), size, size, low.at(0, 0, 0), size, size, radius),
    )
    law, friction = (power(stiffness, 1), hunt_crossley(_RESTITUTION)), coulomb(_FRICTION, _STATIC)
    return Scene(
        Mechanism("aligned_boxes", tuple(Planar(f"{b.name}_move", GROUND, b, normal=Z) for b in (low, high)), pairs),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            *(Contact(name, *law) for name in ("floor", "stack")),
            *(Friction(f"{name}_friction", name, friction) for name in ("floor", "stack")),
            EnergyLedger(),
        ),
        start=Start(position={"low_move.y": size / 2, "high_move.y": 3 * size / 2 + drop, "high_move.x": aside}),
        scales=Scales(length=radius, speed=Parameter("pace", "m/s", 0.1), arm=size),
        summary="a box dropped on an equal one, corner over corner",
    )


def whirling_rod() -> Scene:
    """A rod of eight shapes that turns at ten times its own pace, thrown across the plane of its spin."""
    length, shapes = Parameter("length", "m", 1), 8
    rod = FlexibleRod("rod", length, Parameter("mass", "kg", 0.5), Parameter("stiffness", "N m^2", 8), modes=shapes)
    hinge = Revolute("hinge", GROUND, rod.start, axis=Y)
    return Scene(
        Mechanism("whirling_rod", (hinge, rod)),
        effects=(ConstantSpeed("spin", "hinge", Parameter("spin_speed", "rad/s", 40)), EnergyLedger()),
        start=Start(speed={f"rod.bend_{k}_speed": Parameter(f"thrown_{k}", "m/s", 0.1) for k in range(1, shapes + 1)}),
        scales=Scales(length=Parameter("size", "m", 0.01), speed=Parameter("pace", "m/s", 1), arm=length),
    )


def sliding_table() -> Scene:
    """A flat box that slides on four corners with set-valued friction in two directions."""
    width, height, stiffness = (
        Parameter("width", "m", 0.2),
        Parameter("height", "m", 0.05),
        Parameter("stiffness", "N/m", 1e7),
    )
    gravity = Parameter("gravity", "m/s^2", 9.81)
    table = Body.box("table", width, height, width, mass=_MASS)
    floor = BoxOnPlane("floor", table.at(0, 0, 0), width, height, GROUND.at(0, 0, 0), Y, z=width)
    return Scene(
        Mechanism("sliding_table", (Free("move", GROUND, table),), (floor,)),
        effects=(
            Gravity("gravity", gravity, direction=Direction((Parameter("tangent", "1", 0), -1, 0))),
            Contact("floor", power(stiffness, 1), hunt_crossley(_RESTITUTION)),
            Friction("friction", "floor", coulomb(_FRICTION, _STATIC)),
            EnergyLedger(),
        ),
        start=Start(
            position={"move.y": height / 2 - _MASS * gravity / (4 * stiffness)},
            speed={"move.x": _SPEED, "move.z": _SPEED},
        ),
        scales=Scales(length=Parameter("size", "mm", 1), speed=Parameter("pace", "m/s", 0.1), arm=width),
        summary="a table that slides to rest on four feet",
    )


def ball_over_ball() -> Scene:
    """A ball that rolls without slip over another, and stays on it beyond where it would part."""
    big, lead = Parameter("hill_radius", "m", 1), Parameter("lead", "rad", 0.1)
    ball = Body("ball", _MASS, 2 * _MASS * _RADIUS**2 / 5)
    hill = SphereOnSphere("hill", ball.at(0, 0, 0), GROUND.at(0, 0, 0), _RADIUS, big)
    return Scene(
        Mechanism("ball_over_ball", (Planar("ride", GROUND, ball, normal=Z),), (hill,)),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            RollingWithoutSlip("rolls", "hill"),
            EnergyLedger(),
        ),
        start=Start(position={"ride.x": (big + _RADIUS) * sp.sin(lead), "ride.y": (big + _RADIUS) * sp.cos(lead)}),
        scales=Scales(length=_RADIUS, speed=_SPEED, arm=_RADIUS),
        summary="a ball that rolls over another",
    )


def resting_sleigh() -> Scene:
    """A sleigh on a knife edge at no speed, on a slope across which it may not move."""
    arm = Parameter("arm", "m", 0.1)
    sleigh = Body("sleigh", _MASS, _MASS * arm**2, centre=(arm, 0, 0))
    return Scene(
        Mechanism("resting_sleigh", (Planar("move", GROUND, sleigh, normal=Z),)),
        effects=(
            Gravity("slope", Parameter("pull", "m/s^2", 5), direction=-Y),
            KnifeEdge("skate", sleigh.at(0, 0, 0), Y),
            EnergyLedger(),
        ),
        start=Start(position={"move.angle": Parameter("heading", "rad", math.pi / 2)}),
        scales=Scales(length=arm, speed=_SPEED, arm=arm),
        summary="a sleigh on a knife edge that heads uphill, and turns over",
    )


def faceted_bench() -> Scene:
    """A round slider at 10 m/s over a bench of twenty lines in line, each a tenth of a millisecond long."""
    piece, radius, pace = Parameter("piece", "mm", 1), Parameter("radius", "mm", 5), Parameter("pace", "m/s", 10)
    mass, gravity, stiffness = _MASS, Parameter("gravity", "m/s^2", 9.81), Parameter("bench_stiffness", "N/m", 1e8)
    top = [Line((k * piece, 0)) for k in range(19, -1, -1)]
    bench = Outline(
        "bench", (0, -radius), [Line((20 * piece, -radius)), Line((20 * piece, 0)), *top, Line((0, -radius))]
    )
    disc = Outline("disc", (radius, 0), [Arc((0, radius), (0, 0)), Arc((0, -radius), (0, 0)), Arc((radius, 0), (0, 0))])
    slider = Body("slider", mass, mass * radius**2 / 2)
    height = radius - mass * gravity / stiffness
    return Scene(
        Mechanism(
            "faceted_bench", (Planar("plane", GROUND, slider),),
            (CurveOnCurve("bench", disc, slider.at(0, 0, 0), bench, GROUND.at(0, 0, 0)),),
        ),
        effects=(Gravity("gravity", gravity, direction=-Y), Contact("bench", power(stiffness, 1)), EnergyLedger()),
        start=Start(position={"plane.x": 2 * piece, "plane.y": height}, speed={"plane.x": pace}),
        scales=Scales(length=Parameter("size", "mm", 0.1), speed=Parameter("small", "m/s", 0.1), arm=radius),
        summary="a round slider over a bench of many lines",
    )  # fmt: skip


def _depth(mass: sp.Expr) -> sp.Expr:
    """Penetration of an elastic impact at the start's speed [m]."""
    return ((_EXPONENT + 1) * mass * _SPEED**2 / (2 * _STIFFNESS)) ** (1 / (_EXPONENT + 1))


_BRISTLES = lugre(
    _FRICTION,
    _STATIC,
    v_S=Parameter("stribeck_speed", "m/s", 0.01),
    s_0=Parameter("bristle_stiffness", "1/m", 1e7, "per normal force"),
    s_1=Parameter("bristle_damping", "s/m", 1000, "per normal force"),
    c_v=Parameter("viscous_coefficient", "N s/m", 0),
)
_LAYER = Parameter("friction_speed", "m/s", 1e-7, "over which friction builds up")

HARD_SCENES: dict[str, Callable[[], Scene]] = {
    **{
        f"free_impact_{law.name}": lambda law=law: free_impact(law)  # type: ignore[misc]
        for law in (flores, exact, kelvin_voigt, FORCE_RELEASED, ristow)
    },
    "grazing_ball": grazing_ball,
    "tugged_ball": tugged_ball,
    "shaken_ball": shaken_ball,
    "chattering_relay": chattering_relay,
    "jamming_guide": jamming_guide,
    "whirling_rod": whirling_rod,
    "track_round": track_round,
    "faceted_bench": faceted_bench,
    "rocking_block": rocking_block,
    "aligned_boxes": aligned_boxes,
    "sliding_table": sliding_table,
    "ball_over_ball": ball_over_ball,
    "resting_sleigh": resting_sleigh,
    "row_of_5": lambda: row_of_spheres(5),
    "row_of_50": lambda: row_of_spheres(50),
    "touching_row_of_5": lambda: touching_row(5),
    "touching_row_of_50": lambda: touching_row(50),
    "struck_from_both_sides": struck_from_both_sides,
    "falling_chain_of_3": lambda: falling_chain(3),
    "falling_chain_of_8": lambda: falling_chain(8),
    "unlike_masses": unlike_masses,
    **COUPLED,
    **AT_LIMITS,
    **LATE_SLIPS,
    **WORN,
    "incline_coulomb": lambda: incline(coulomb(_FRICTION, _STATIC)),
    "incline_lugre": lambda: incline(_BRISTLES),
    "incline_smooth_coulomb": lambda: incline(smooth_coulomb(_FRICTION, _LAYER)),
}
